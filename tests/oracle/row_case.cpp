// SPDX-License-Identifier: MIT
#include "oracle/row_case.h"

#include <fmt/format.h>

#include <cmath>

namespace strobe::oracle {

// A tap within single precision of the border of two pixels may take either pixel: one of three jitters must fit.
static double distanceToExpected(const RowCase& filter, double value, int x, int y) {
  double jitter = filter.jitter(x, y), nearest = kInfinity;
  for (double shift : {0.0, -2e-4, 2e-4})
    nearest = std::min(nearest, std::abs(value - filter.expected(x, jitter + shift)));
  return nearest;
}

void expectPerPixel(const RowCase& filter, const image::Image& color) {
  double worst = 0;
  std::string place;
  for (int y = 0; y < color.height; ++y) {
    for (int x = filter.first; x < filter.last; ++x) {
      double error = distanceToExpected(filter, color.at(x, y, 0), x, y);
      if (error <= worst) continue;
      worst = error;
      double expected = filter.expected(x, filter.jitter(x, y));
      place = fmt::format("({}, {}) is {}, expected {}", x, y, color.at(x, y, 0), expected);
    }
  }
  EXPECT_LE(worst, 2e-3) << filter.what << " " << place;
}

}  // namespace strobe::oracle
