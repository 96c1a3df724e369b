// SPDX-License-Identifier: MIT
// Charts as inline SVG (svg.h): two axes and series drawn between them. A series is a line with marks, a band,
// scattered marks or bars; its points may have error bars. Series differ without colour: by dashes, marks or hatch, and
// by a label at the right.
//
// To add a kind of series, add a value to `Series::Kind` and a row to `kDrawings` in chart.cpp.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "page/frame.h"

namespace strobe::page {

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Values from `low` to `high`; NaN: not given.
struct Interval {
  double low = kNone, high = kNone;
  bool given() const { return low == low && high == high; }
};

struct Point {
  double x = 0, y = 0;        // y: NaN leaves a gap
  std::string tip;            // tooltip
  bool hollow = false;        // mark without filling, for example if a limit was met
  bool faint = false;         // unreliable; the line segments at both sides are drawn faint
  Interval y_range, x_range;  // error bars; extent of a band; -infinity: lower border of the chart
  std::string name;           // label beside the mark; scattered points only
};

struct Series {
  enum class Kind { line, band, scatter, bar };
  std::string label;  // "": no label
  int style = 0;      // style of svg.h
  std::vector<Point> points;
  Kind kind = Kind::line;
  bool stepped = false;  // line as a staircase, first along x, then along y (Pareto front)
};

// Line across the chart at one value of an axis, for example a budget.
struct Guide {
  double at = 0;
  std::string tip;
  bool horizontal = false;  // at a value of y, not of x
};

// Bars need slots along x; bars of one slot stand side by side in the order of their series. Bars start at 0, or at the
// lower border of a logarithmic axis.
struct Chart {
  std::string about;  // alternative text
  Axis x, y;
  std::vector<Series> series;
  std::vector<Guide> guides;
};

// Chart as inline SVG; `width` and `height` in pixels of the page.
std::string svgOf(const Chart& chart, int width = 940, int height = 430);

// Frame of the chart, which maps values to pixels.
Frame frameOf(const Chart& chart, int width = 940, int height = 430);

}  // namespace strobe::page
