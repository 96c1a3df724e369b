// SPDX-License-Identifier: MIT
// Effects of experimental factors on a measured value: main effects, pairwise interactions and slopes, with 95 %
// intervals.
//
// Values are compared within blocks. A block of a factor is the set of observations with equal levels of all other
// factors. A block is complete if it contains every level of the factor. Only complete blocks count, so that all levels
// are compared under the same conditions. If all blocks are complete, the effect of a level is the mean of its
// observations minus the mean of all observations. The interval is Student's t over the blocks, each taken as one
// independent draw of conditions: it measures the variation of the effect between blocks. Intervals are not widened for
// the number of effects.
#pragma once

#include <cstddef>
#include <vector>

#include "math/statistics.h"

namespace strobe {

// Mean of independent values with its t interval. All NaN without values; the interval is NaN for one value.
Estimate estimatedMean(const std::vector<double>& values);

// An observed value, finite, and its level of each factor, counted from 0. A negative level: the observation lacks the
// factor.
struct Observation {
  std::vector<int> levels;
  double value = 0;
};
using Observations = std::vector<Observation>;  // all with the same number of factors

// Main effect of one factor. Element i of `levels`: the value at level i minus the mean of its block, averaged over
// complete blocks.
struct MainEffect {
  std::vector<Estimate> levels;
  size_t blocks = 0, incomplete = 0;
};
MainEffect mainEffect(const Observations& observations, size_t factor, size_t levels);

// Main effect of a factor without complete blocks: the value at a level minus the mean of all values, averaged over the
// observations of that level. The interval is over these observations. The result includes the effects of all other
// factors that vary.
MainEffect unpairedEffect(const Observations& observations, size_t factor, size_t levels);

// Interaction of two factors. Element [i][j] of `cells`, for level i of `first` and level j of `second`: cell - mean of
// its row - mean of its column + mean of the block, averaged over complete blocks. Blocks have equal levels of all
// factors but these two.
struct Interaction {
  std::vector<std::vector<Estimate>> cells;
  size_t blocks = 0, incomplete = 0;
};
Interaction interaction(const Observations& observations, size_t first, size_t second, size_t first_levels,
                        size_t second_levels);

// Slope of a straight line over `x` by least squares, with a separate intercept for each stratum. The degrees of
// freedom of its t interval are n - strata - 1. NaN if x does not vary within strata.
struct Slope {
  Estimate slope;
  size_t observations = 0;
};
Slope slopeWithin(const std::vector<double>& x, const std::vector<double>& y, const std::vector<int>& strata);

}  // namespace strobe
