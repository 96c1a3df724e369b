// SPDX-License-Identifier: MIT
// The frame of a chart: its axes, where values lie between them, ticks and titles.
#pragma once

#include <string>
#include <vector>

#include "page/scale.h"
#include "page/svg.h"

namespace strobe::page {

struct Axis {
  std::string title;
  Scale::Kind kind = Scale::Kind::linear;
  std::string unit;      // behind the label of each tick: " %"
  bool rounded = false;  // reaches to round numbers
  double decades = 0;    // of a logarithmic axis: so many below its largest value; what is smaller, 0 included,
                         // lies on its border. 0: as many as the values need, and 0 has a place of its own
  std::vector<std::string> names;  // of slots: of the values 0, 1, 2 ...
  std::vector<double> ends;        // values that it reaches in any case

  Scale scaleOf(std::vector<double> values) const;
  // What a tick says, the `index`-th of the scale's.
  std::string labelOf(const Tick& tick, size_t index) const;
};

// One of slots, with these names.
Axis slotAxis(const std::string& title, std::vector<std::string> names);

// Pixels of the picture, x right and y down.
class Frame {
 public:
  // `left` and `right`: pixels beside the plot, for labels.
  Frame(Scale x, Scale y, int width, int height, double left, double right);

  double px(double value) const { return xAt(x_.at(value)); }
  double py(double value) const { return yAt(y_.at(value)); }
  // At 0 to 1 along an axis.
  double xAt(double share) const { return left_ + inset(x_) + share * (right_ - left_ - 2 * inset(x_)); }
  double yAt(double share) const { return bottom_ - inset(y_) - share * (bottom_ - top_ - 2 * inset(y_)); }

  double left() const { return left_; }
  double right() const { return right_; }
  double top() const { return top_; }
  double bottom() const { return bottom_; }
  const Scale& x() const { return x_; }
  const Scale& y() const { return y_; }

  // Grid, ticks, titles and, where an axis has a 0 before a gap, the break.
  void draw(Svg& svg, const Axis& x, const Axis& y) const;

 private:
  static constexpr double kInset = 12;  // between the border and the first value
  static double inset(const Scale& scale) { return scale.slot() > 0 ? 0 : kInset; }
  void drawX(Svg& svg, const Axis& axis) const;
  void drawY(Svg& svg, const Axis& axis) const;

  Scale x_, y_;
  double left_, right_, top_, bottom_;
};

// Pixels at the left of a plot that labels of the vertical axis take.
double leftOf(const Axis& axis, const Scale& scale);

}  // namespace strobe::page
