// SPDX-License-Identifier: MIT
// A line fitted through hand-computed points.
#include <gtest/gtest.h>

#include <cmath>

#include "math/effects.h"

namespace strobe {
namespace line_test {

// Sums of squares about the means 2 and 5: 10 of x, 21 of x and y, 46 of y; residual 46 - 44.1 = 1.9. The 97.5 %
// quantile of Student's t with 3 degrees of freedom is scipy.stats.t.ppf(0.975, 3).
TEST(LineFit, FitsPoints) {
  LineFit line = lineThrough({0, 1, 2, 3, 4}, {1, 3, 4, 8, 9});
  EXPECT_NEAR(line.slope.value, 2.1, 1e-12);
  EXPECT_NEAR(line.intercept, 0.8, 1e-12);
  EXPECT_NEAR(line.r2, 44.1 / 46, 1e-12);
  double half = 3.182446305284263 * std::sqrt(1.9 / 3 / 10);
  EXPECT_NEAR(line.slope.high - line.slope.value, half, 1e-9);
  EXPECT_NEAR(line.slope.value - line.slope.low, half, 1e-9);
  EXPECT_NEAR(line.at(10), 21.8, 1e-12);
}

TEST(LineFit, TooFewPointsGiveNoNumber) {
  LineFit two = lineThrough({1, 3}, {5, 9});
  EXPECT_DOUBLE_EQ(two.slope.value, 2);
  EXPECT_DOUBLE_EQ(two.intercept, 3);
  EXPECT_TRUE(std::isnan(two.slope.low)) << "two points have no interval";
  EXPECT_TRUE(std::isnan(lineThrough({1, 1, 1}, {2, 3, 4}).slope.value)) << "x does not vary";
  LineFit flat = lineThrough({1, 2, 3}, {4, 4, 4});
  EXPECT_DOUBLE_EQ(flat.slope.value, 0);
  EXPECT_TRUE(std::isnan(flat.r2)) << "y has no variance";
  EXPECT_TRUE(std::isnan(lineThrough({}, {}).intercept));
}

}  // namespace line_test
}  // namespace strobe
