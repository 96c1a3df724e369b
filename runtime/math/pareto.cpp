// SPDX-License-Identifier: MIT
#include "math/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strobe {

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
