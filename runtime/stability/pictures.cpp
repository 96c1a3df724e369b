// SPDX-License-Identifier: MIT
#include "stability/pictures.h"

#include <cmath>
#include <limits>

namespace strobe::stability {

static double beyond(double value, const Right& right) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  return std::max(right.low - value, value - right.high) - right.tolerance;
}

static std::string describe(double value, const Right& right, int x, int y) {
  std::string range = right.low == right.high ? fmt::format("{:.9g}", right.low)
                                              : fmt::format("{:.9g} to {:.9g}", right.low, right.high);
  return fmt::format("pixel ({}, {}) is {:.9g}, expected {} within {:.3g}", x, y, value, range, right.tolerance);
}

Finding compare(const image::Image& picture, const RightAt& right, std::vector<lab::Shot> shots) {
  Finding finding;
  finding.shots = std::move(shots);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int c = 0; c < 3; ++c) {
        std::optional<Right> wanted = right(x, y, c);
        if (!wanted) continue;
        double value = picture.at(x, y, c), excess = beyond(value, *wanted);
        if (!(excess > finding.excess)) continue;
        finding.holds = false;
        finding.excess = excess;
        finding.x = x;
        finding.y = y;
        finding.text = describe(value, *wanted, x, y);
      }
  return finding;
}

}  // namespace strobe::stability
