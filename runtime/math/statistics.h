// SPDX-License-Identifier: MIT
// Statistics of measured values. All return NaN for too few values: a missing measurement never becomes a number.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace strobe {

// Estimate with the ends of its 95 % interval. NaN for too few values.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

// Quantile `q` in [0, 1], interpolated linearly between the two nearest ranks: rank q (n - 1) of the sorted values,
// counted from 0 (definition 7 of Hyndman and Fan, 1996).
double quantile(std::vector<double> values, double q);

// Middle value. For an even number of values, the mean of the two middle values.
double median(std::vector<double> values);

// Interval that contains the median of the distribution of independent values, with probability `confidence` or more.
// The ends are two of the values, chosen by the binomial distribution: each side is missed with a probability of at
// most (1 - confidence) / 2. Confidence 0.95 needs at least six values.
std::array<double, 2> medianInterval(std::vector<double> values, double confidence = 0.95);

// Median with its 95 % interval.
Estimate estimatedMedian(const std::vector<double>& values);

// Ratios values[i] / base[i] for the indices i of both lists, where base[i] > 0.
std::vector<double> ratiosOf(const std::vector<double>& values, const std::vector<double>& base);

// Ratio of the medians of two lists of independent values. The interval is the quotient of two 97.5 % intervals, so
// that its confidence is at least 95 %. It needs at least seven values in each list, all positive.
Estimate ratioOfMedians(const std::vector<double>& values, const std::vector<double>& base);

double mean(const std::vector<double>& values);

// Spearman's rank correlation of two lists of equal length: the correlation of the ranks. Equal values share the mean
// of their ranks. NaN if the lengths differ, or if all values of a list are equal.
double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b);

// Sum of squared deviations from the mean, divided by n - 1. At least two values.
double variance(const std::vector<double>& values);

// Standard deviation of the mean of independent values: sqrt(variance / n). At least two values.
double standardError(const std::vector<double>& values);

// Indices of the points that no other point dominates, by ascending first value; the first of equal points. A point
// dominates another one if neither of its values is larger and one is smaller. Points with a value that is not finite
// are left out.
std::vector<size_t> paretoFront(const std::vector<std::pair<double, double>>& points);

}  // namespace strobe
