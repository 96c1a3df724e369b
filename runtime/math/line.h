// SPDX-License-Identifier: MIT
// Straight line through points by least squares, with equal weights.
#pragma once

#include <vector>

#include "math/statistics.h"

namespace strobe {

// Slope with its confidence interval, intercept and coefficient of determination of a least-squares line y(x).
struct LineFit {
  Estimate slope;  // t interval with n - 2 degrees of freedom; the interval is NaN for fewer than three points
  double intercept = std::numeric_limits<double>::quiet_NaN();
  double r2 = std::numeric_limits<double>::quiet_NaN();  // coefficient of determination; NaN if y does not vary

  double at(double x) const { return intercept + slope.value * x; }
};

// `x` and `y` have the same size and finite values. All results are NaN if x does not vary.
LineFit lineThrough(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace strobe
