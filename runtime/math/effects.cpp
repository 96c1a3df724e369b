// SPDX-License-Identifier: MIT
#include "math/effects.h"

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

std::vector<std::vector<double>> estimatesInput(size_t count) { return std::vector<std::vector<double>>(count); }

}  // namespace

Estimate estimatedMean(const std::vector<double>& values) {
  Estimate estimate;
  estimate.value = mean(values);
  if (values.size() < 2) return estimate;
  double half = tQuantile(double(values.size() - 1)) * standardError(values);
  estimate.low = estimate.value - half, estimate.high = estimate.value + half;
  return estimate;
}

MainEffect mainEffect(const Observations& observations, size_t factor, size_t levels) {
  MainEffect effect;
  std::vector<std::vector<double>> differences = estimatesInput(levels);
  for (const auto& [block, cells] : blocksOf(observations, {factor})) {
    if (cells.size() < levels) {
      ++effect.incomplete;
      continue;
    }
    ++effect.blocks;
    double middle = 0;
    for (const auto& [cell, values] : cells) middle += mean(values) / double(levels);
    for (const auto& [cell, values] : cells) differences[size_t(cell[0])].push_back(mean(values) - middle);
  }
  for (const std::vector<double>& of_level : differences) effect.levels.push_back(estimatedMean(of_level));
  return effect;
}

MainEffect unpairedEffect(const Observations& observations, size_t factor, size_t levels) {
  MainEffect effect;
  std::vector<double> all;
  std::vector<std::vector<double>> differences = estimatesInput(levels);
  for (const Observation& one : observations)
    if (one.levels[factor] >= 0) all.push_back(one.value);
  double middle = mean(all);
  for (const Observation& one : observations)
    if (one.levels[factor] >= 0) differences[size_t(one.levels[factor])].push_back(one.value - middle);
  for (const std::vector<double>& of_level : differences) effect.levels.push_back(estimatedMean(of_level));
  return effect;
}

Interaction interaction(const Observations& observations, size_t first, size_t second, size_t first_levels,
                        size_t second_levels) {
  Interaction result;
  std::vector<std::vector<std::vector<double>>> rests(first_levels, estimatesInput(second_levels));
  for (const auto& [block, cells] : blocksOf(observations, {first, second})) {
    if (cells.size() < first_levels * second_levels) {
      ++result.incomplete;
      continue;
    }
    ++result.blocks;
    std::vector<double> rows(first_levels, 0), columns(second_levels, 0);
    double middle = 0;
    for (const auto& [cell, values] : cells) {
      double value = mean(values);
      rows[size_t(cell[0])] += value / double(second_levels);
      columns[size_t(cell[1])] += value / double(first_levels);
      middle += value / double(first_levels * second_levels);
    }
    for (const auto& [cell, values] : cells) {
      size_t row = size_t(cell[0]), column = size_t(cell[1]);
      rests[row][column].push_back(mean(values) - rows[row] - columns[column] + middle);
    }
  }
  for (const auto& row : rests) {
    result.cells.emplace_back();
    for (const std::vector<double>& cell : row) result.cells.back().push_back(estimatedMean(cell));
  }
  return result;
}

Slope slopeWithin(const std::vector<double>& x, const std::vector<double>& y, const std::vector<int>& strata) {
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
  Slope result;
  result.observations = x.size();
  if (!(xx > 0)) return result;
  result.slope.value = xy / xx;
  double degrees = double(x.size()) - double(members.size()) - 1;
  if (degrees < 1) return result;
  double rest = std::max(0.0, yy - xy * xy / xx);
  double half = tQuantile(degrees) * std::sqrt(rest / degrees / xx);
  result.slope.low = result.slope.value - half, result.slope.high = result.slope.value + half;
  return result;
}

}  // namespace strobe
