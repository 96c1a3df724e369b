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
#include <limits>
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

// Main effect of one factor, or interaction of two. Element i of `levels` belongs to level i; of two factors, to level
// i / n of the first and i % n of the second, which has n levels. Main effect: the value at the level minus the mean of
// its block, averaged over complete blocks. Interaction: value - mean of the first's level - mean of the second's level
// + mean of the block, averaged over complete blocks.
struct Effect {
  std::vector<Estimate> levels;
  size_t blocks = 0, incomplete = 0;
};
// `factors`: one or two. `levels`: number of levels of each.
Effect effectOf(const Observations& observations, const std::vector<size_t>& factors,
                const std::vector<size_t>& levels);

// Main effect of a factor without complete blocks: the value at a level minus the mean of all values, averaged over the
// observations of that level. The interval is over these observations. The result includes the effects of all other
// factors that vary.
Effect unpairedEffect(const Observations& observations, size_t factor, size_t levels);

// Slope of a straight line over `x` by least squares, with a separate intercept for each stratum. The degrees of
// freedom of its t interval are n - strata - 1. NaN if x does not vary within strata.
Estimate slopeWithin(const std::vector<double>& x, const std::vector<double>& y, const std::vector<int>& strata);

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
