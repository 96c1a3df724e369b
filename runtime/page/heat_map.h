// SPDX-License-Identifier: MIT
// A value over two axes of slots: each cell is shaded in one of `kSteps` steps, and says its value, so that it reads
// without colour.
#pragma once

#include <string>
#include <vector>

#include "page/frame.h"

namespace strobe::page {

struct HeatMap {
  std::string about;                                  // for people who cannot see it
  std::string x_title, y_title;                       // of the axes
  std::string value_title;                            // of the values, beside the legend
  std::vector<std::string> x, y;                      // names of columns, left to right, and of rows, from the top
  std::vector<std::vector<double>> values;            // by row, then by column; NaN: nothing was measured
  std::vector<std::vector<std::string>> texts, tips;  // empty, or of the same size: what stands in a cell, what it says
                                                      // where the pointer rests
  Scale::Kind scale = Scale::Kind::linear;            // of the values: linear or log
  bool mark_smallest = false;                         // a frame around the smallest value
};

inline constexpr int kSteps = 9;

// Which step, 0 to kSteps - 1, a value gets.
int stepOf(const Scale& scale, double value);

// As high as its rows need. Asserts that `values` has the size of the axes.
std::string svgOf(const HeatMap& map, int width = 940);

}  // namespace strobe::page
