// SPDX-License-Identifier: MIT
#include "math/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace strobe {
namespace statistics_test {

TEST(Statistics, MedianOfAnEvenCountIsTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({9, 1, 5}), 5);
  EXPECT_EQ(median({4, 1, 3, 100}), 3.5);
}

// Values of the interpolated definition (R's type 7, NumPy's "linear").
TEST(Statistics, QuantilesAreInterpolated) {
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0), 1);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 1), 4);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.25), 1.75);
  EXPECT_NEAR(quantile({10, 20, 30, 40, 50}, 0.9), 46, 1e-12);
}

TEST(Statistics, InfiniteValueWithWeightZeroHasNoEffect) {
  double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(median({1, 2, inf}), 2);
  EXPECT_EQ(quantile({1, 2, inf}, 1), inf);
}

// scipy.stats.binom(25, 0.5).ppf(0.025) = 8: the 8th and 18th of 25 values; the smallest and largest of 6.
TEST(Statistics, MedianIntervalEndsAtValues) {
  std::vector<double> values;
  for (int i = 25; i >= 1; --i) values.push_back(i);
  EXPECT_EQ(medianInterval(values), (std::array<double, 2>{8, 18}));
  EXPECT_EQ(medianInterval({3, 1, 2, 6, 5, 4}), (std::array<double, 2>{1, 6}));
  EXPECT_TRUE(std::isnan(medianInterval({1, 2, 3, 4, 5})[0]));
}

// scipy.stats.binom(n, 0.5).cdf(0) is 1/128 for 7 values and 1/64 for 6: the limit 0.0125 lies between.
TEST(Statistics, HigherConfidenceNeedsMoreValues) {
  EXPECT_EQ(medianInterval({7, 1, 2, 6, 5, 4, 3}, 0.975), (std::array<double, 2>{1, 7}));
  EXPECT_TRUE(std::isnan(medianInterval({1, 2, 3, 4, 5, 6}, 0.975)[0]));
  EXPECT_TRUE(std::isnan(medianInterval({})[0]));
}

TEST(Statistics, RatiosAreOfTheSameIndex) {
  EXPECT_EQ(ratiosOf({6, 8, 9, 7}, {2, 4, 0}), (std::vector<double>{3, 2})) << "pairs with a positive divisor";
  Estimate ratio = estimatedMedian(ratiosOf({2, 4, 6, 8, 10, 12}, {1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(ratio.value, 7);
  EXPECT_EQ(ratio.low, 2);
  EXPECT_EQ(ratio.high, 12);
}

// scipy.stats.binom(15, 0.5): cdf(2) = 0.0037, cdf(3) = 0.0176 > 0.0125: the 3rd and 13th of 15 values at 97.5 %.
TEST(Statistics, QuotientIntervalCombinesTwoIntervals) {
  std::vector<double> values, base;
  for (int i = 1; i <= 15; ++i) values.push_back(10 + i), base.push_back(100 + i);
  Estimate ratio = ratioOfMedians(values, base);
  EXPECT_NEAR(ratio.value, 18.0 / 108, 1e-15);
  EXPECT_NEAR(ratio.low, 13.0 / 113, 1e-15);
  EXPECT_NEAR(ratio.high, 23.0 / 103, 1e-15);
  EXPECT_TRUE(std::isnan(ratioOfMedians({1, 2}, {1, 2}).low)) << "two values have no interval";
  EXPECT_EQ(ratioOfMedians({1, 2}, {1, 2}).value, 1);
  EXPECT_TRUE(std::isnan(ratioOfMedians(values, {0, 0, 0}).value));
}

TEST(Statistics, MeanVarianceAndStandardErrorMatch) {
  std::vector<double> values = {2, 4, 4, 4, 5, 5, 7, 9};  // squared deviations from 5 add up to 32
  EXPECT_EQ(mean(values), 5);
  EXPECT_NEAR(variance(values), 32.0 / 7, 1e-12);
  EXPECT_NEAR(standardError(values), std::sqrt(32.0 / 7 / 8), 1e-12);
}

// Expected values: scipy.stats.spearmanr.
TEST(Statistics, RanksAreCorrelated) {
  EXPECT_NEAR(rankCorrelation({3, 1, 4, 1, 5, 9, 2, 6, 5, 3}, {2, 7, 1, 8, 2, 8, 1, 8, 2, 8}), 0.13471506281091267,
              1e-14);
  EXPECT_NEAR(rankCorrelation({1, 2, 3, 4}, {10, 20, 40, 30}), 0.8, 1e-14);
  EXPECT_NEAR(rankCorrelation({1, 2, 3}, {-1, -100, -1e9}), -1, 1e-14) << "only the order counts";
  EXPECT_TRUE(std::isnan(rankCorrelation({1, 2, 3}, {5, 5, 5})));
}

TEST(Statistics, TooFewValuesGiveNoNumber) {
  EXPECT_TRUE(std::isnan(rankCorrelation({}, {})));
  EXPECT_TRUE(std::isnan(rankCorrelation({1, 2}, {1})));
  EXPECT_TRUE(std::isnan(median({})));
  EXPECT_TRUE(std::isnan(mean({})));
  EXPECT_TRUE(std::isnan(variance({1})));
  EXPECT_TRUE(std::isnan(standardError({1})));
}

}  // namespace statistics_test
}  // namespace strobe
