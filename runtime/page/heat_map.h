// SPDX-License-Identifier: MIT
// Heat map: a value over two axes of slots. Each cell has one of `kSteps` shades and shows its value as text, so that
// the map is readable without colour.
#pragma once

#include <string>
#include <vector>

#include "page/frame.h"

namespace strobe::page {

struct HeatMap {
  std::string about;                                  // alternative text
  std::string x_title, y_title;                       // axis titles
  std::string value_title;                            // title of the legend
  std::vector<std::string> x, y;                      // names of columns, left to right, and of rows, from the top
  std::vector<std::vector<double>> values;            // by row, then by column; NaN: not measured
  std::vector<std::vector<std::string>> texts, tips;  // per cell: text and tooltip; or empty
  Scale::Kind scale = Scale::Kind::linear;            // scale of the values: linear or log
  bool mark_smallest = false;                         // draws a frame around the smallest value
};

inline constexpr int kSteps = 9;

// Shade of a value, 0 to kSteps - 1.
int stepOf(const Scale& scale, double value);

// Heat map as inline SVG, as high as its rows need. Asserts that `values` has the size of the axes.
std::string svgOf(const HeatMap& map, int width = 940);

}  // namespace strobe::page
