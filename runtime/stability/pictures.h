// SPDX-License-Identifier: MIT
// Pixel-by-pixel comparison of pictures, for invariants.
#pragma once

#include <functional>

#include "stability/invariants.h"

namespace strobe::stability {

using Picture = std::shared_ptr<const image::Image>;

// Expected range and tolerance of a channel of a pixel.
struct Right {
  double low, high, tolerance;
};
inline Right exactly(double value, double tolerance) { return {value, value, tolerance}; }

// Compares the three colours of each pixel that `right` returns a range for, and reports the worst pixel. The error of
// a value that is not finite is infinite.
using RightAt = std::function<std::optional<Right>(int x, int y, int channel)>;
Finding compare(const image::Image& picture, const RightAt& right, std::vector<lab::Shot> shots);

}  // namespace strobe::stability
