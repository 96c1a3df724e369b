// SPDX-License-Identifier: MIT
// Charts as inline SVG (svg.h). A chart is two axes and what is drawn between them, one `Series` over another: lines
// with marks, bands, scattered marks, bars, each with error bars where points have them. heat_map.h draws a value over
// two axes. What a series is can be seen without colour: by its dashes, marks or hatch, and by its label at the right.
//
// Another kind of series is a value of `Series::Kind` and a row of `kDrawings` in chart.cpp.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "page/frame.h"

namespace strobe::page {

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// From one value to another; NaN: there is none.
struct Interval {
  double low = kNone, high = kNone;
  bool given() const { return low == low && high == high; }
};

struct Point {
  double x = 0, y = 0;        // y: NaN leaves a gap
  std::string tip;            // shown where the pointer rests
  bool hollow = false;        // a mark without filling: a limit was met, say
  bool faint = false;         // not to be trusted, nor the step that leads to it
  Interval y_range, x_range;  // error bars; the extent of a band, where -infinity is the lower border of the chart
  std::string name;           // of scattered points: beside the mark
};

struct Series {
  enum class Kind { line, band, scatter, bar };
  std::string label;  // "": none
  int style = 0;      // svg.h
  std::vector<Point> points;
  Kind kind = Kind::line;
  bool stepped = false;  // of a line: along x, then along y: the border of what is dominated by its points
};

// Across the chart where an axis has a value: a budget, a value that other charts keep.
struct Guide {
  double at = 0;
  std::string tip;
  bool horizontal = false;  // at a value of y
};

// Bars need slots along x; bars of the same slot stand side by side in the order of their series. They stand on 0, or
// on the lower border of a logarithmic axis.
struct Chart {
  std::string about;  // for people who cannot see it
  Axis x, y;
  std::vector<Series> series;
  std::vector<Guide> guides;
};

// `width` x `height` in pixels of the page.
std::string svgOf(const Chart& chart, int width = 940, int height = 430);

// Where the values of a chart lie in it.
Frame frameOf(const Chart& chart, int width = 940, int height = 430);

}  // namespace strobe::page
