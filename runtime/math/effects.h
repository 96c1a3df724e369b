// SPDX-License-Identifier: MIT
// How a measured value depends on what was varied: main effects, pairwise interactions, slopes, with 95 % intervals.
//
// Values are compared within blocks. A block of a factor holds the observations that are alike in all other factors; it
// is complete where every level of the factor is among them. Complete blocks alone count, so that no level is compared
// under other conditions than its neighbours; where all are complete, the effect of a level is the mean of its
// observations less the mean of all. The interval is Student's t over the blocks, each taken as one independent draw of
// conditions: it says how alike the effect is from block to block. Intervals of many effects are not widened for their
// number.
#pragma once

#include <cstddef>
#include <vector>

#include "math/statistics.h"

namespace strobe {

// Mean of independent values with its t interval: NaN without values, and as ends with fewer than two.
Estimate estimatedMean(const std::vector<double>& values);

// What was observed: a value at a level of each factor, counted from 0; below 0, the observation does not have the
// factor. Values are finite.
struct Observation {
  std::vector<int> levels;
  double value = 0;
};
using Observations = std::vector<Observation>;  // all with as many factors

// One factor: by level, the mean over complete blocks of the difference from the mean of the block.
struct MainEffect {
  std::vector<Estimate> levels;
  size_t blocks = 0, incomplete = 0;
};
MainEffect mainEffect(const Observations& observations, size_t factor, size_t levels);

// The same without blocks, of factors that never stand alone: by level, the mean of the differences from the mean of
// all, with the interval over its observations. Whatever else varied is in it.
MainEffect unpairedEffect(const Observations& observations, size_t factor, size_t levels);

// Two factors: by level of `first` and level of `second`, the mean over complete blocks of what neither explains: cell
// - mean of its row - mean of its column + mean of the block. Blocks are alike in all factors but these two.
struct Interaction {
  std::vector<std::vector<Estimate>> cells;
  size_t blocks = 0, incomplete = 0;
};
Interaction interaction(const Observations& observations, size_t first, size_t second, size_t first_levels,
                        size_t second_levels);

// A straight line through values over `x`, with a height of its own for each stratum: its slope by least squares, its t
// interval with n - strata - 1 degrees of freedom. NaN where x does not vary within strata.
struct Slope {
  Estimate slope;
  size_t observations = 0;
};
Slope slopeWithin(const std::vector<double>& x, const std::vector<double>& y, const std::vector<int>& strata);

}  // namespace strobe
