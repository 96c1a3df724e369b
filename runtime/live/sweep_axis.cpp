// SPDX-License-Identifier: MIT
#include "live/sweep_axis.h"

#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "live/widgets.h"

namespace strobe::live {

using Type = plan::ParamDesc::Type;

static const double kFarApart = 15;  // least ratio of the ends of a logarithmic range
static const double kFarOff = 32;    // largest ratio of upper end to value for a sweep of the whole range
static const int kLinearSteps = 6, kLeastSteps = 4, kMostSuggested = 9;

bool hasRange(const plan::ParamDesc& declaration) {
  return declaration.type == Type::Int || declaration.type == Type::Float;
}

bool canBeSwept(const lab::Control& control) {
  const plan::ParamDesc& declaration = control.declaration;
  if (control.group == "shot" && declaration.name == "aa") return false;  // affects saved pictures only
  return declaration.type != Type::Choice || declaration.choices.size() > 1;
}

static double numberIn(const plan::Value& value) {
  if (const auto* whole = std::get_if<int64_t>(&value)) return double(*whole);
  return std::get<double>(value);
}

// Rounds integers to whole numbers and other values to six digits: 0.30000000000000004 becomes 0.3.
static double rounded(const plan::ParamDesc& declaration, double value) {
  return declaration.type == Type::Int ? std::round(value) : std::stod(fmt::format("{:.6g}", value));
}

static double limited(const plan::ParamDesc& declaration, double value) {
  if (declaration.min) value = std::max(value, *declaration.min);
  if (declaration.max) value = std::min(value, *declaration.max);
  return value;
}

// Number of values. A logarithmic range grows by a factor of about two per value, within the limits of the number.
static int stepsOf(const plan::ParamDesc& declaration, const SweepRange& range) {
  double span = range.to - range.from;
  if (range.logarithmic)
    return std::clamp(int(std::lround(std::log2(range.to / range.from))) + 1, kLeastSteps, kMostSuggested);
  bool few = declaration.type == Type::Int && span < kMostSuggested;
  return few ? std::max(2, int(span) + 1) : kLinearSteps;
}

SweepRange suggestedRange(const lab::Control& control) {
  const plan::ParamDesc& declaration = control.declaration;
  Widget widget = widgetOf(declaration);
  bool whole = declaration.type == Type::Int;
  bool slides = widget.kind == Widget::Kind::IntSlider || widget.kind == Widget::Kind::FloatSlider;
  double value = numberIn(control.value), around = std::abs(value);
  SweepRange range{widget.low, widget.high, 2, false};
  // Most values of a range that is far too wide show nothing new.
  if (!slides || widget.logarithmic || (value != 0 && widget.high > kFarOff * around)) {
    range.from = value == 0 ? 0 : value < 0 ? -4 * around : around / 4;
    range.to = value == 0 ? (whole ? 7 : 1) : value < 0 ? around : 4 * around;
  }
  range.from = rounded(declaration, limited(declaration, range.from));
  range.to = rounded(declaration, limited(declaration, range.to));
  range.logarithmic = range.from > 0 && range.to / range.from >= kFarApart;
  range.steps = stepsOf(declaration, range);
  return range;
}

static void checkRange(const plan::ParamDesc& declaration, const SweepRange& range, int most) {
  auto refuse = [&](const std::string& what) { throw Error(fmt::format("sweep of {}: {}", declaration.name, what)); };
  bool finite = std::isfinite(range.from) && std::isfinite(range.to);
  if (!finite || range.from == range.to) refuse("the ends must be two different numbers");
  for (double end : {range.from, range.to})
    if (limited(declaration, end) != end) refuse(fmt::format("{:g} is out of range", end));
  if (range.logarithmic && (range.from <= 0 || range.to <= 0))
    refuse("the ends of a logarithmic range must be above 0");
  if (range.steps < 2 || range.steps > most)
    refuse(fmt::format("the number of steps is {}, not 2 to {}", range.steps, most));
}

static void add(SweepAxis& axis, const plan::Value& value) {
  addOnce(axis.values, plan::checkValue(axis.declaration, value, {}));
}

SweepAxis axisOf(const plan::ParamDesc& declaration, const SweepRange& range, int most) {
  checkRange(declaration, range, most);
  SweepAxis axis{declaration, range.logarithmic, {}};
  for (int i = 0; i < range.steps; ++i) {
    double share = double(i) / (range.steps - 1);
    double value = range.logarithmic ? range.from * std::pow(range.to / range.from, share)
                                     : range.from + (range.to - range.from) * share;
    value = limited(declaration, rounded(declaration, value));
    if (declaration.type == Type::Int) add(axis, int64_t(value));
    else add(axis, value);
  }
  return axis;
}

SweepAxis axisOf(const lab::Control& control, int most) {
  const plan::ParamDesc& declaration = control.declaration;
  if (!canBeSwept(control)) throw Error(fmt::format("'{}' has no values to sweep", declaration.name));
  if (hasRange(declaration)) {
    SweepRange range = suggestedRange(control);
    range.steps = std::min(range.steps, most);
    return axisOf(declaration, range, most);
  }
  if (declaration.type == Type::Bool) return {declaration, false, {false, true}};
  SweepAxis axis{declaration, false, {}};
  for (const std::string& choice : declaration.choices)
    if (int(axis.values.size()) < most) axis.values.push_back(choice);
  if (!contains(axis.values, control.value)) axis.values.back() = control.value;
  return axis;
}

SweepAxis axisOf(const plan::ParamDesc& declaration, const std::vector<std::string>& values) {
  SweepAxis axis{declaration, false, {}};
  for (const std::string& value : values) add(axis, value);
  return axis;
}

}  // namespace strobe::live
