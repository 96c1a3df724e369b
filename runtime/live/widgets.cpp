// SPDX-License-Identifier: MIT
#include "live/widgets.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace strobe::live {

using Type = plan::ParamDesc::Type;

// Span above which a slider is logarithmic. A slider as wide as a panel has about 250 positions; on a linear scale of a
// larger span, most positions would have nearly equivalent values.
static const double kEvenSpan = 1e3;
// Span above which a number has no slider, because no position on such a slider would be useful.
static const double kWidestSlider = 1e7;

static std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

static std::string formatOf(const plan::ParamDesc& declaration) {
  std::string unit;
  for (char c : declaration.unit) unit += c == '%' ? "%%" : std::string(1, c);
  return (declaration.type == Type::Int ? "%d" : "%.4g") + (unit.empty() ? "" : " " + unit);
}

static Widget numberWidget(const plan::ParamDesc& declaration) {
  bool whole = declaration.type == Type::Int;
  Widget widget{whole ? Widget::Kind::IntDrag : Widget::Kind::FloatDrag, 0, 0, false, formatOf(declaration)};
  if (!declaration.min || !declaration.max) return widget;
  widget.low = *declaration.min;
  widget.high = *declaration.max;
  double span = widget.high - widget.low;
  bool has_scale = span <= kWidestSlider && (widget.low > 0 ? widget.high / widget.low : span) <= kWidestSlider;
  if (!has_scale) return widget;
  widget.kind = whole ? Widget::Kind::IntSlider : Widget::Kind::FloatSlider;
  widget.logarithmic = widget.low > 0 ? widget.high / widget.low > kEvenSpan : widget.low == 0 && span > kEvenSpan;
  return widget;
}

Widget widgetOf(const plan::ParamDesc& declaration) {
  switch (declaration.type) {
    case Type::Bool:
      return {Widget::Kind::Checkbox, 0, 0, false, ""};
    case Type::Choice:
      return {declaration.choices.empty() ? Widget::Kind::Text : Widget::Kind::Combo, 0, 0, false, ""};
    default:
      return numberWidget(declaration);
  }
}

std::string samplesText(int have, int of) {
  return have < of ? fmt::format("{} of {} samples", have, of) : fmt::format("{} samples", have);
}

double shareOf(const Widget& slider, double value) {
  double low = slider.low, high = slider.high;
  if (slider.logarithmic) {
    // A scale from 0 begins at the same value as ImGui's.
    bool whole = slider.kind == Widget::Kind::IntSlider;
    double least = low > 0 ? low : whole ? 0.1 : 1e-4;
    return std::clamp(std::log(std::max(value, least) / least) / std::log(high / least), 0.0, 1.0);
  }
  return high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0;
}

bool isOpen(const plan::ParamDesc& declaration, double value) { return declaration.min && value < *declaration.min; }

static std::string valueText(const plan::ParamDesc& declaration, const plan::Value& value) {
  const auto* number = std::get_if<double>(&value);
  return number && isOpen(declaration, *number) ? "auto" : lab::plainText(declaration, value);
}

static std::string rangeText(const plan::ParamDesc& declaration) {
  std::string unit = declaration.unit.empty() ? "" : " " + declaration.unit;
  std::string or_auto = declaration.has_auto ? ", or auto" : "";
  if (declaration.min && declaration.max) {
    return fmt::format("{} to {}{}{}", *declaration.min, *declaration.max, unit, or_auto);
  }
  if (declaration.min) return fmt::format("at least {}{}", *declaration.min, unit);
  if (declaration.max) return fmt::format("at most {}{}", *declaration.max, unit);
  return declaration.unit;
}

std::string tooltipOf(const lab::Control& control) {
  const plan::ParamDesc& declaration = control.declaration;
  std::string text = declaration.name + "\n" + declaration.doc;
  bool number = declaration.type == Type::Int || declaration.type == Type::Float;
  std::string range = number ? rangeText(declaration) : "";
  if (!range.empty()) text += "\n" + range;
  for (const auto& [choice, meaning] : declaration.values) text += fmt::format("\n\n{}: {}", choice, meaning);
  text += fmt::format("\n\n{}: {}", control.origin.empty() ? "default" : control.origin,
                      valueText(declaration, control.value));
  if (!control.idle.empty()) text += "\nhas no effect: " + control.idle;
  if (!control.place.empty()) text += "\ndeclared in " + control.place;
  return text;
}

bool isFound(const lab::Control& control, const std::string& text) {
  const plan::ParamDesc& declaration = control.declaration;
  std::string searched = lower(declaration.name + " " + control.group + " " + declaration.unit + " " + declaration.doc);
  std::istringstream words(lower(text));
  for (std::string word; words >> word;)
    if (searched.find(word) == std::string::npos) return false;
  return true;
}

std::string shortName(const lab::Control& control) {
  std::string prefix = control.group + ".";
  const std::string& name = control.declaration.name;
  return name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

}  // namespace strobe::live
