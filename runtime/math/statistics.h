// SPDX-License-Identifier: MIT
// Summaries of a list of measured values. All are NaN where there are too few values for them: a missing measurement
// never becomes a number.
#pragma once

#include <array>
#include <limits>
#include <vector>

namespace strobe {

// With the ends of its 95 % interval; NaN where there are too few values.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

// The value below which the share `q` of [0, 1] lies, interpolated linearly between the two nearest ranks: rank
// q (n - 1) of the sorted values, counted from 0 (definition 7 of Hyndman and Fan, 1996).
double quantile(std::vector<double> values, double q);

// The middle value; of an even number of values, the mean of the two in the middle.
double median(std::vector<double> values);

// An interval that holds the median of what independent values are drawn from in at least that share of such lists: two
// of the values, so many of each side left out that more fall there with a probability of at most half the rest
// (binomial). 95 of 100 need at least six values.
std::array<double, 2> medianInterval(std::vector<double> values, double confidence = 0.95);

// The median with that interval.
Estimate estimatedMedian(const std::vector<double>& values);

// Each value as a multiple of the one of the same index in `base`, where that is above 0; as many as both have.
std::vector<double> ratiosOf(const std::vector<double>& values, const std::vector<double>& base);

// The median of independent values as a multiple of that of others. The ends are quotients of the ends of two intervals
// that hold with 97.5 of 100 each, so that both hold with at least 95: at least seven values of each, all above 0.
Estimate ratioOfMedians(const std::vector<double>& values, const std::vector<double>& base);

double mean(const std::vector<double>& values);

// Spearman's rank correlation of two lists of equal length: the correlation of the ranks, where equal values share the
// mean of their ranks. NaN if the lengths differ, or if all values of a list are equal.
double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b);

// Sum of squared deviations from the mean, divided by n - 1. At least two values.
double variance(const std::vector<double>& values);

// Standard deviation of the mean of independent values: sqrt(variance / n). At least two values.
double standardError(const std::vector<double>& values);

}  // namespace strobe
