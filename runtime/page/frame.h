// SPDX-License-Identifier: MIT
// Frame of a chart: axes, mapping of values to pixels, ticks and titles.
#pragma once

#include <string>
#include <vector>

#include "page/scale.h"
#include "page/svg.h"

namespace strobe::page {

// Axis of a chart: title, kind of scale, unit, and the values that its range includes.
struct ChartAxis {
  std::string title;
  Scale::Kind kind = Scale::Kind::linear;
  std::string unit;      // follows the label of each tick: " %"
  bool rounded = false;  // ends at round numbers
  double decades = 0;    // range of a logarithmic axis below its largest value; smaller values, with 0, lie on the
                         // border. 0: all values are in the range, and the value 0 has its own place
  std::vector<std::string> names;  // slots only: names of the values 0, 1, 2 ...
  std::vector<double> ends;        // values that the axis always includes

  Scale scaleOf(std::vector<double> values) const;
  // Label of `tick`, which has number `index` on the scale; "" for a small tick.
  std::string labelOf(const Tick& tick, size_t index) const;
};

// Axis of slots with these names.
ChartAxis slotAxis(const std::string& title, std::vector<std::string> names);

// Maps the values of two axes to pixels of the chart, x right and y down.
class ChartFrame {
 public:
  // `left`, `right`: margins for labels, pixels.
  ChartFrame(Scale x, Scale y, int width, int height, double left, double right);

  double px(double value) const { return xAt(x_.at(value)); }
  double py(double value) const { return yAt(y_.at(value)); }
  // Pixel at `share`, 0 to 1 along an axis.
  double xAt(double share) const { return left_ + inset(x_) + share * (right_ - left_ - 2 * inset(x_)); }
  double yAt(double share) const { return bottom_ - inset(y_) - share * (bottom_ - top_ - 2 * inset(y_)); }

  double left() const { return left_; }
  double right() const { return right_; }
  double top() const { return top_; }
  double bottom() const { return bottom_; }
  const Scale& x() const { return x_; }
  const Scale& y() const { return y_; }

  // Draws grid, ticks and titles, and a break mark on an axis with a gap after 0.
  void draw(Svg& svg, const ChartAxis& x, const ChartAxis& y) const;

 private:
  static constexpr double kInset = 12;  // pixels between the border and the first value
  static double inset(const Scale& scale) { return scale.slot() > 0 ? 0 : kInset; }
  void drawX(Svg& svg, const ChartAxis& axis) const;
  void drawY(Svg& svg, const ChartAxis& axis) const;

  Scale x_, y_;
  double left_, right_, top_, bottom_;
};

// Width of the left margin for the labels of a vertical axis, pixels.
double leftOf(const ChartAxis& axis, const Scale& scale);

}  // namespace strobe::page
