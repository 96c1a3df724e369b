// SPDX-License-Identifier: MIT
// A straight line through points, by least squares: every point counts alike.
#pragma once

#include <vector>

#include "math/statistics.h"

namespace strobe {

struct Line {
  Estimate slope;  // with its t interval of n - 2 degrees of freedom: NaN with fewer than three points
  double intercept = std::numeric_limits<double>::quiet_NaN();
  double r2 = std::numeric_limits<double>::quiet_NaN();  // share of the variation of y; NaN where y does not vary

  double at(double x) const { return intercept + slope.value * x; }
};

// All NaN where x does not vary. Both have as many values, all finite.
Line lineThrough(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace strobe
