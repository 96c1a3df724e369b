// SPDX-License-Identifier: MIT
#include "math/effects.h"

#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <map>
#include <set>

#include "math/statistics.h"

namespace strobe {

namespace {

constexpr double kTail = 0.025;  // tail probability on each side of an interval

double tQuantile(double degrees) {
  return boost::math::quantile(boost::math::complement(boost::math::students_t(degrees), kTail));
}

// Groups observations into blocks with equal levels of all factors except `varied`. Within a block, observations are
// grouped into cells by their levels of `varied`. Observations that lack a varied factor are left out.
using Cells = std::map<std::vector<int>, std::vector<double>>;
std::map<std::vector<int>, Cells> blocksOf(const Observations& observations, const std::vector<size_t>& varied) {
  std::map<std::vector<int>, Cells> blocks;
  for (const Observation& one : observations) {
    std::vector<int> block = one.levels, cell;
    for (size_t factor : varied) cell.push_back(one.levels[factor]), block[factor] = 0;
    bool has_all = true;
    for (int level : cell) has_all = has_all && level >= 0;
    if (has_all) blocks[block][cell].push_back(one.value);
  }
  return blocks;
}

}  // namespace

Estimate estimatedMean(const std::vector<double>& values) {
  Estimate estimate;
  estimate.value = mean(values);
  if (values.size() < 2) return estimate;
  double half = tQuantile(double(values.size() - 1)) * standardError(values);
  estimate.low = estimate.value - half, estimate.high = estimate.value + half;
  return estimate;
}

Effect effectOf(const Observations& observations, const std::vector<size_t>& factors,
                const std::vector<size_t>& levels) {
  Effect effect;
  const bool of_pair = factors.size() == 2;
  const size_t count = of_pair ? levels[0] * levels[1] : levels[0];
  std::vector<std::vector<double>> rests(count);
  for (const auto& [block, cells] : blocksOf(observations, factors)) {
    if (cells.size() < count) {
      ++effect.incomplete;
      continue;
    }
    ++effect.blocks;
    double middle = 0;
    std::array<std::vector<double>, 2> means = {std::vector<double>(levels.front()),
                                                std::vector<double>(levels.back())};
    for (const auto& [cell, values] : cells) {
      const double value = mean(values);
      middle += value / double(count);
      for (size_t f = 0; of_pair && f < 2; ++f) means[f][size_t(cell[f])] += value / double(levels[1 - f]);
    }
    for (const auto& [cell, values] : cells) {
      const size_t first = size_t(cell.front()), last = size_t(cell.back());
      if (of_pair) rests[first * levels[1] + last].push_back(mean(values) - means[0][first] - means[1][last] + middle);
      else rests[first].push_back(mean(values) - middle);
    }
  }
  for (const std::vector<double>& of_level : rests) effect.levels.push_back(estimatedMean(of_level));
  return effect;
}

Effect unpairedEffect(const Observations& observations, size_t factor, size_t levels) {
  Effect effect;
  std::vector<double> all;
  std::vector<std::vector<double>> differences(levels);
  for (const Observation& one : observations)
    if (one.levels[factor] >= 0) all.push_back(one.value);
  double middle = mean(all);
  for (const Observation& one : observations)
    if (one.levels[factor] >= 0) differences[size_t(one.levels[factor])].push_back(one.value - middle);
  for (const std::vector<double>& of_level : differences) effect.levels.push_back(estimatedMean(of_level));
  return effect;
}

Estimate slopeWithin(const std::vector<double>& x, const std::vector<double>& y, const std::vector<int>& strata) {
  std::map<int, std::vector<size_t>> members;
  for (size_t i = 0; i < x.size(); ++i) members[strata[i]].push_back(i);
  double xx = 0, xy = 0, yy = 0;
  for (const auto& [stratum, indices] : members) {
    double mean_x = 0, mean_y = 0, n = double(indices.size());
    for (size_t i : indices) mean_x += x[i] / n, mean_y += y[i] / n;
    for (size_t i : indices) {
      double dx = x[i] - mean_x, dy = y[i] - mean_y;
      xx += dx * dx, xy += dx * dy, yy += dy * dy;
    }
  }
  Estimate slope;
  if (!(xx > 0)) return slope;
  slope.value = xy / xx;
  double degrees = double(x.size()) - double(members.size()) - 1;
  if (degrees < 1) return slope;
  double rest = std::max(0.0, yy - xy * xy / xx);
  double half = tQuantile(degrees) * std::sqrt(rest / degrees / xx);
  slope.low = slope.value - half, slope.high = slope.value + half;
  return slope;
}

LineFit lineThrough(const std::vector<double>& x, const std::vector<double>& y) {
  LineFit line;
  line.slope = slopeWithin(x, y, std::vector<int>(x.size(), 0));
  line.intercept = mean(y) - line.slope.value * mean(x);
  double all = 0, rest = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    all += std::pow(y[i] - mean(y), 2);
    rest += std::pow(y[i] - line.at(x[i]), 2);
  }
  if (all > 0) line.r2 = 1 - rest / all;
  return line;
}

}  // namespace strobe
