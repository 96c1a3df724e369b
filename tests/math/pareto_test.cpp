// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "math/statistics.h"

namespace strobe {
namespace pareto_test {

TEST(Pareto, FrontHasTheUndominatedPoints) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(paretoFront({{3, 1}, {1, 3}, {2, 2}, {2, 3}, {3, 2}, {1, 3}, {0, none}, {none, 0}}),
            (std::vector<size_t>{1, 2, 0}))
      << "the first of equal points";
  EXPECT_TRUE(paretoFront({}).empty());
}

// The definition, tested for every pair.
TEST(Pareto, MatchesTheDefinition) {
  std::mt19937 random(3);
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < 300; ++i) points.emplace_back(random() % 40, random() % 40);
  std::vector<bool> on_front(points.size());
  for (size_t i : paretoFront(points)) on_front[i] = true;
  for (size_t i = 0; i < points.size(); ++i) {
    bool dominated = false;
    for (size_t k = 0; k < points.size(); ++k) {
      bool no_worse = points[k].first <= points[i].first && points[k].second <= points[i].second;
      dominated = dominated || (no_worse && (points[k] != points[i] || k < i));
    }
    EXPECT_EQ(on_front[i], !dominated) << i;
  }
}

}  // namespace pareto_test
}  // namespace strobe
