// SPDX-License-Identifier: MIT
// What follows one another, as a bar each: from the top, where it begins and how long it takes.
#pragma once

#include <string>
#include <vector>

#include "page/chart.h"

namespace strobe::page {

struct Waterfall {
  struct Bar {
    std::string name;
    double start = 0, length = 0;
    Interval end_range;   // error bar about the end
    std::string text;     // at the right of the bar
    std::string tip;      // shown where the pointer rests
    bool hollow = false;  // of no step, but of what is between them
  };
  std::string about;  // for people who cannot see it
  Axis x;             // reaches from 0
  double left = 0;    // pixels beside the plot that names have at least
  std::vector<Bar> bars;
};

// Gives all the same extent and place, so that bars can be compared from one to another.
void align(std::vector<Waterfall>& waterfalls);

// As high as its bars need.
std::string svgOf(const Waterfall& waterfall, int width = 940);

}  // namespace strobe::page
