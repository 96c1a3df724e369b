// SPDX-License-Identifier: MIT
#include "math/line.h"

#include <cmath>

#include "math/effects.h"

namespace strobe {

LineFit lineThrough(const std::vector<double>& x, const std::vector<double>& y) {
  LineFit line;
  line.slope = slopeWithin(x, y, std::vector<int>(x.size(), 0)).slope;
  line.intercept = mean(y) - line.slope.value * mean(x);
  double all = 0, rest = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    all += std::pow(y[i] - mean(y), 2);
    rest += std::pow(y[i] - line.at(x[i]), 2);
  }
  if (all > 0) line.r2 = 1 - rest / all;
  return line;
}

}  // namespace strobe
