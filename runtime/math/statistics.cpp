// SPDX-License-Identifier: MIT
#include "math/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.h"

namespace strobe {

static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double quantile(std::vector<double> values, double q) {
  STROBE_ASSERT(q >= 0 && q <= 1, "{}", q);
  if (values.empty()) return kNone;
  double rank = q * double(values.size() - 1);
  auto lower = values.begin() + std::ptrdiff_t(rank);
  std::nth_element(values.begin(), lower, values.end());
  double share = rank - std::floor(rank);
  // Skip a neighbour with share 0, because 0 times infinity is NaN.
  return share == 0 ? *lower : std::lerp(*lower, *std::min_element(lower + 1, values.end()), share);
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

std::array<double, 2> medianInterval(std::vector<double> values, double confidence) {
  std::sort(values.begin(), values.end());
  double n = double(values.size()), below = 0;
  size_t left_out = 0;  // at each end
  for (; left_out < values.size(); ++left_out) {
    double k = double(left_out);
    below += std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) - n * std::log(2.0));
    if (below > (1 - confidence) / 2) break;
  }
  if (left_out == 0) return {kNone, kNone};
  return {values[left_out - 1], values[values.size() - left_out]};
}

Estimate estimatedMedian(const std::vector<double>& values) {
  std::array<double, 2> interval = medianInterval(values);
  return {median(values), interval[0], interval[1]};
}

std::vector<double> ratiosOf(const std::vector<double>& values, const std::vector<double>& base) {
  std::vector<double> ratios;
  for (size_t i = 0; i < values.size() && i < base.size(); ++i)
    if (base[i] > 0) ratios.push_back(values[i] / base[i]);
  return ratios;
}

Estimate ratioOfMedians(const std::vector<double>& values, const std::vector<double>& base) {
  constexpr double kEach = 0.975;
  std::array<double, 2> of_values = medianInterval(values, kEach), of_base = medianInterval(base, kEach);
  if (!(median(base) > 0)) return {};
  if (!(of_base[0] > 0)) return {median(values) / median(base), kNone, kNone};
  return {median(values) / median(base), of_values[0] / of_base[1], of_values[1] / of_base[0]};
}

double mean(const std::vector<double>& values) {
  if (values.empty()) return kNone;
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

// Ranks of the values, from 0. Equal values share the mean of their ranks.
static std::vector<double> ranksOf(const std::vector<double>& values) {
  std::vector<size_t> order(values.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (size_t first = 0, last; first < order.size(); first = last) {
    for (last = first; last < order.size() && values[order[last]] == values[order[first]];) ++last;
    for (size_t i = first; i < last; ++i) ranks[order[i]] = 0.5 * double(first + last - 1);
  }
  return ranks;
}

double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size() || a.empty()) return kNone;
  const std::vector<double> ranks_a = ranksOf(a), ranks_b = ranksOf(b);
  const double middle = 0.5 * double(a.size() - 1);  // mean of all ranks
  double products = 0, squares_a = 0, squares_b = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const double from_a = ranks_a[i] - middle, from_b = ranks_b[i] - middle;
    products += from_a * from_b, squares_a += from_a * from_a, squares_b += from_b * from_b;
  }
  return squares_a > 0 && squares_b > 0 ? products / std::sqrt(squares_a * squares_b) : kNone;
}

double variance(const std::vector<double>& values) {
  if (values.size() < 2) return kNone;
  double middle = mean(values), sum = 0;
  for (double value : values) sum += (value - middle) * (value - middle);
  return sum / double(values.size() - 1);
}

double standardError(const std::vector<double>& values) { return std::sqrt(variance(values) / double(values.size())); }

std::vector<size_t> paretoFront(const std::vector<std::pair<double, double>>& points) {
  std::vector<size_t> order;
  for (size_t i = 0; i < points.size(); ++i)
    if (std::isfinite(points[i].first) && std::isfinite(points[i].second)) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return points[a] < points[b]; });
  double least = std::numeric_limits<double>::infinity();
  std::erase_if(order, [&](size_t i) {
    bool dominated = points[i].second >= least;
    least = std::min(least, points[i].second);
    return dominated;
  });
  return order;
}

}  // namespace strobe
