// SPDX-License-Identifier: MIT
#include "page/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strobe::page {

namespace {

constexpr double kTop = 14, kBottom = 54, kLeastLeft = 76, kTitleWidth = 40;

}  // namespace

Scale ChartAxis::scaleOf(std::vector<double> values) const {
  values.insert(values.end(), ends.begin(), ends.end());
  if (kind == Scale::Kind::slots)
    for (size_t i = 0; i < names.size(); ++i) values.push_back(double(i));
  if (kind != Scale::Kind::log || decades <= 0) return Scale(kind, values, rounded);
  std::erase_if(values, [](double value) { return !(value > 0) || !std::isfinite(value); });
  double most = values.empty() ? 1 : *std::max_element(values.begin(), values.end());
  for (double& value : values) value = std::max(value, most * std::pow(10.0, -decades));
  return Scale(kind, values, rounded);
}

std::string ChartAxis::labelOf(const Tick& tick, size_t index) const {
  if (!names.empty()) return index < names.size() ? names[index] : "";
  return tick.label.empty() ? "" : tick.label + unit;
}

ChartAxis slotAxis(const std::string& title, std::vector<std::string> names) {
  ChartAxis axis;
  axis.title = title;
  axis.kind = Scale::Kind::slots;
  axis.names = std::move(names);
  return axis;
}

double leftOf(const ChartAxis& axis, const Scale& scale) {
  double widest = 0;
  std::vector<Tick> ticks = scale.ticks();
  for (size_t i = 0; i < ticks.size(); ++i) widest = std::max(widest, estimatedWidth(axis.labelOf(ticks[i], i)));
  return std::max(kLeastLeft, widest + kTitleWidth);
}

ChartFrame::ChartFrame(Scale x, Scale y, int width, int height, double left, double right)
    : x_(std::move(x)), y_(std::move(y)), left_(left), right_(width - right), top_(kTop), bottom_(height - kBottom) {}

void ChartFrame::drawX(Svg& svg, const ChartAxis& axis) const {
  std::vector<Tick> ticks = x_.ticks();
  for (size_t i = 0; i < ticks.size(); ++i) {
    double x = xAt(ticks[i].at);
    std::string label = axis.labelOf(ticks[i], i);
    if (!label.empty()) {
      if (x_.slot() == 0) svg.path("grid", fmt::format("M{:.1f} {}V{}", x, top_, bottom_));
      svg.text("tick", x, bottom_ + 18, label, Svg::Anchor::middle);
    }
    svg.path("tickmark", fmt::format("M{:.1f} {}v{}", x, bottom_, label.empty() ? 3 : 6));
  }
  double gap = 0.55 * x_.gap();
  if (x_.hasZero()) svg.path("break", fmt::format("M{:.1f} {}l6 -10m4 0l-6 10", xAt(gap), bottom_ + 5));
  svg.text("title", (left_ + right_) / 2, bottom_ + 44, axis.title, Svg::Anchor::middle);
}

void ChartFrame::drawY(Svg& svg, const ChartAxis& axis) const {
  std::vector<Tick> ticks = y_.ticks();
  for (size_t i = 0; i < ticks.size(); ++i) {
    double y = yAt(ticks[i].at);
    std::string label = axis.labelOf(ticks[i], i);
    if (!label.empty()) {
      if (y_.slot() == 0) svg.path("grid", fmt::format("M{} {:.1f}H{}", left_, y, right_));
      svg.text("tick", left_ - 9, y + 4, label, Svg::Anchor::end);
    }
    svg.path("tickmark", fmt::format("M{} {:.1f}h{}", left_, y, label.empty() ? -3 : -6));
  }
  double gap = 0.55 * y_.gap();
  if (y_.hasZero()) svg.path("break", fmt::format("M{} {:.1f}l10 -6m0 4l-10 6", left_ - 5, yAt(gap)));
  svg.upwardText("title", 16, (top_ + bottom_) / 2, axis.title);
}

void ChartFrame::draw(Svg& svg, const ChartAxis& x, const ChartAxis& y) const {
  svg.rectangle("plot", left_, top_, right_ - left_, bottom_ - top_);
  drawX(svg, x);
  drawY(svg, y);
}

}  // namespace strobe::page
