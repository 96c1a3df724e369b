// SPDX-License-Identifier: MIT
// Effects, interactions and slopes of hand-computed observations; study/effects_test.cpp compares larger ones with
// SciPy.
#include "math/effects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/constants.h"

namespace strobe {
namespace effects_test {

// The 97.5 % quantiles of Student's t with 1 and 2 degrees of freedom, in closed form.
const double kT1 = std::tan(0.475 * kPi), kT2 = 0.95 * std::sqrt(2 / 0.0975);

// Two arms at three samples: 1 2 3 and 4 5 9.
Observations crossed() { return {{{0, 0}, 1}, {{0, 1}, 2}, {{0, 2}, 3}, {{1, 0}, 4}, {{1, 1}, 5}, {{1, 2}, 9}}; }

TEST(Effects, MeanHasItsInterval) {
  Estimate estimate = estimatedMean({1, 2, 3});
  EXPECT_DOUBLE_EQ(estimate.value, 2);
  EXPECT_NEAR(estimate.high - 2, kT2 / std::sqrt(3), 1e-11);
  EXPECT_NEAR(estimate.low + estimate.high, 4, 1e-11);
  EXPECT_DOUBLE_EQ(estimatedMean({5}).value, 5);
  EXPECT_TRUE(std::isnan(estimatedMean({5}).low)) << "one value has no interval";
  EXPECT_TRUE(std::isnan(estimatedMean({}).value));
}

TEST(Effects, AreDifferencesFromTheMeanInCompleteBlocks) {
  Effect arms = effectOf(crossed(), {0}, {2});
  EXPECT_EQ(arms.blocks, 3u);
  EXPECT_NEAR(arms.levels[0].value, 2 - 4, 1e-11);
  EXPECT_NEAR(arms.levels[1].value, 6 - 4, 1e-11);
  EXPECT_NEAR(arms.levels[1].high - 2, kT2 * 0.5, 1e-11)
      << "values 1.5, 1.5 and 3: standard deviation sqrt(0.75), standard error 0.5";
  Effect samples = effectOf(crossed(), {1}, {3});
  EXPECT_EQ(samples.blocks, 2u);
  EXPECT_NEAR(samples.levels[2].value, (3.0 + 9) / 2 - 4, 1e-11);
  EXPECT_NEAR(samples.levels[2].high - samples.levels[2].value, kT1 * 1, 1e-11) << "from values 1 and 3";
}

TEST(Effects, BlocksThatLackALevelAreLeftOut) {
  Observations observations = crossed();
  observations.pop_back();
  Effect samples = effectOf(observations, {1}, {3});
  EXPECT_EQ(samples.blocks, 1u);
  EXPECT_EQ(samples.incomplete, 1u);
  EXPECT_DOUBLE_EQ(samples.levels[0].value, -1);
  EXPECT_TRUE(std::isnan(samples.levels[0].low)) << "one block has no interval";
  EXPECT_EQ(effectOf(observations, {0}, {2}).blocks, 2u);
}

// An observation without a factor does not count for its effect, and does not form another block of the other factors.
TEST(Effects, UseObservationsWithTheFactor) {
  Observations observations = crossed();
  observations.push_back({{0, -1}, 100});
  EXPECT_DOUBLE_EQ(effectOf(observations, {1}, {3}).levels[0].value, effectOf(crossed(), {1}, {3}).levels[0].value);
  EXPECT_EQ(effectOf(observations, {0}, {2}).incomplete, 1u);
}

TEST(Effects, InteractionIsTheResidualOfRowsAndColumns) {
  Observations twice = crossed();
  for (Observation& one : twice) one.levels.push_back(0);
  for (const Observation& one : crossed()) twice.push_back({{one.levels[0], one.levels[1], 1}, 2 * one.value});
  Effect result = effectOf(twice, {0, 1}, {2, 3});
  EXPECT_EQ(result.blocks, 2u);
  // Interaction 9 - 6 - 6 + 4 = 1 in the first block, 2 in the second.
  EXPECT_NEAR(result.levels[5].value, 1.5, 1e-11);
  EXPECT_NEAR(result.levels[5].high - 1.5, kT1 * 0.5, 1e-11);
  EXPECT_NEAR(result.levels[2].value, -1.5, 1e-11);
  double sum = 0;
  for (size_t sample = 0; sample < 3; ++sample) sum += result.levels[sample].value;
  EXPECT_NEAR(sum, 0, 1e-11);
  twice.pop_back();
  EXPECT_EQ(effectOf(twice, {0, 1}, {2, 3}).incomplete, 1u);
}

TEST(Effects, UnpairedIncludesAllOtherVariation) {
  Effect arms = unpairedEffect(crossed(), 0, 2);
  EXPECT_DOUBLE_EQ(arms.levels[0].value, -2);
  EXPECT_NEAR(arms.levels[0].high + 2, kT2 / std::sqrt(3), 1e-11) << "from values 1, 2 and 3";
}

TEST(Effects, SlopeIsWithinStrata) {
  Estimate slope = slopeWithin({1, 2, 3, 1, 2, 3}, {1, 2, 3, 11, 12, 13}, {0, 0, 0, 1, 1, 1});
  EXPECT_DOUBLE_EQ(slope.value, 1);
  EXPECT_NEAR(slope.low, 1, 1e-11) << "exact lines with different intercepts";
  slope = slopeWithin({0, 1, 2, 3}, {0, 1, 1, 2}, {0, 0, 0, 0});
  EXPECT_NEAR(slope.value, 0.6, 1e-11);
  EXPECT_NEAR(slope.high - 0.6, kT2 * std::sqrt(0.2 / 2 / 5), 1e-11);
  EXPECT_TRUE(std::isnan(slopeWithin({1, 1}, {2, 3}, {0, 0}).value)) << "x does not vary";
  EXPECT_TRUE(std::isnan(slopeWithin({1, 2}, {2, 3}, {0, 0}).low)) << "no degrees of freedom";
}

}  // namespace effects_test
}  // namespace strobe
