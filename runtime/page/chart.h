// SPDX-License-Identifier: MIT
// Charts as inline SVG (svg.h): two axes and series drawn between them. A series is a line with marks, a band or
// scattered marks; its points may have error bars. Series differ without colour: by dashes and marks, and by a label at
// the right.
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

// One point of a chart series: x, y, optional error bar, tooltip and the style of its mark.
struct ChartPoint {
  double x = 0, y = 0;  // y: NaN leaves a gap
  std::string tip;      // tooltip
  bool hollow = false;  // mark without filling, for example if a limit was met
  bool faint = false;   // unreliable; the line segments at both sides are drawn faint
  Interval y_range;     // error bar; extent of a band; -infinity: lower border of the chart
};

// Data series of a chart: points drawn as a line, a band or scattered marks, with a style and a label.
struct Series {
  enum class Kind { line, band, scatter };
  std::string label;  // "": no label
  int style = 0;      // style of svg.h
  std::vector<ChartPoint> points;
  Kind kind = Kind::line;
  bool stepped = false;  // line as a staircase, first along x, then along y (Pareto front)
};

// Upright line across the chart at a value of x.
struct Guide {
  double at = 0;
  std::string tip;
};

// Chart as a value: two axes, data series and upright guide lines.
struct Chart {
  std::string about;  // alternative text
  ChartAxis x, y;
  std::vector<Series> series;
  std::vector<Guide> guides;
};

// Chart as inline SVG; `width` and `height` in pixels of the page.
std::string svgOf(const Chart& chart, int width = 940, int height = 430);

// Frame of the chart, which maps values to pixels.
ChartFrame frameOf(const Chart& chart, int width = 940, int height = 430);

}  // namespace strobe::page
