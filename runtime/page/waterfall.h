// SPDX-License-Identifier: MIT
// Waterfall chart: consecutive steps as bars from the top, each from its start over its length.
#pragma once

#include <string>
#include <vector>

#include "page/chart.h"

namespace strobe::page {

// Waterfall chart as a value: one bar per step, with start, length and optional error bar, on a common x axis.
struct Waterfall {
  struct Bar {
    std::string name;
    double start = 0, length = 0;
    Interval end_range;   // error bar at the end
    std::string text;     // right of the bar
    std::string tip;      // tooltip
    bool hollow = false;  // time between steps, not a step
  };
  std::string about;  // alternative text
  ChartAxis x;        // starts at 0
  double left = 0;    // minimum width of the names beside the plot, pixels
  std::vector<Bar> bars;
};

// Gives all waterfalls the same x range and left margin, so that their bars are comparable.
void align(std::vector<Waterfall>& waterfalls);

// Waterfall as inline SVG, as high as its bars need.
std::string svgOf(const Waterfall& waterfall, int width = 940);

}  // namespace strobe::page
