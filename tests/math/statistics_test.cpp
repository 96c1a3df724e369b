// SPDX-License-Identifier: MIT
#include "math/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace strobe {
namespace {

TEST(Statistics, TheMedianOfAnEvenNumberIsTheMeanOfTheTwoInTheMiddle) {
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({9, 1, 5}), 5);
  EXPECT_EQ(median({4, 1, 3, 100}), 3.5);
}

// Known values of the interpolated definition (R's type 7, NumPy's "linear").
TEST(Statistics, QuantilesAreInterpolated) {
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0), 1);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 1), 4);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.25), 1.75);
  EXPECT_NEAR(quantile({10, 20, 30, 40, 50}, 0.9), 46, 1e-12);
}

TEST(Statistics, AnInfiniteValueIsNoNeighbourOfWhatItHasNoShareIn) {
  double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(median({1, 2, inf}), 2);
  EXPECT_EQ(quantile({1, 2, inf}, 1), inf);
}

// scipy.stats.binom(25, 0.5).ppf(0.025) = 8: the 8th and the 18th of 25 values; of 6 the least and the largest.
TEST(Statistics, TheIntervalOfAMedianLiesBetweenTwoOfTheValues) {
  std::vector<double> values;
  for (int i = 25; i >= 1; --i) values.push_back(i);
  EXPECT_EQ(medianInterval(values), (std::array<double, 2>{8, 18}));
  EXPECT_EQ(medianInterval({3, 1, 2, 6, 5, 4}), (std::array<double, 2>{1, 6}));
  EXPECT_TRUE(std::isnan(medianInterval({1, 2, 3, 4, 5})[0]));
}

TEST(Statistics, MeanVarianceAndStandardError) {
  std::vector<double> values = {2, 4, 4, 4, 5, 5, 7, 9};  // squared deviations from 5 add up to 32
  EXPECT_EQ(mean(values), 5);
  EXPECT_NEAR(variance(values), 32.0 / 7, 1e-12);
  EXPECT_NEAR(standardError(values), std::sqrt(32.0 / 7 / 8), 1e-12);
}

TEST(Statistics, TooFewValuesGiveNoNumber) {
  EXPECT_TRUE(std::isnan(median({})));
  EXPECT_TRUE(std::isnan(mean({})));
  EXPECT_TRUE(std::isnan(variance({1})));
  EXPECT_TRUE(std::isnan(standardError({1})));
}

}  // namespace
}  // namespace strobe
