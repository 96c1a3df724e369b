// SPDX-License-Identifier: MIT
// Summaries of a list of measured values. All are NaN where there are too few values for them: a missing measurement
// never becomes a number.
#pragma once

#include <array>
#include <vector>

namespace strobe {

// The value below which the share `q` of [0, 1] lies, interpolated linearly between the two nearest ranks: rank
// q (n - 1) of the sorted values, counted from 0 (definition 7 of Hyndman and Fan, 1996).
double quantile(std::vector<double> values, double q);

// The middle value; of an even number of values, the mean of the two in the middle.
double median(std::vector<double> values);

// An interval that holds the median of what independent values are drawn from in at least 95 of 100 such lists: two of
// the values, so many of each side left out that more fall there with a probability of at most 1/40 (binomial). At
// least six values.
std::array<double, 2> medianInterval(std::vector<double> values);

double mean(const std::vector<double>& values);

// Sum of squared deviations from the mean, divided by n - 1. At least two values.
double variance(const std::vector<double>& values);

// Standard deviation of the mean of independent values: sqrt(variance / n). At least two values.
double standardError(const std::vector<double>& values);

}  // namespace strobe
