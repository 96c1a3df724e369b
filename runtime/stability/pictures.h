// SPDX-License-Identifier: MIT
// Comparison of pictures, pixel by pixel, for invariants.
#pragma once

#include <functional>

#include "stability/invariants.h"

namespace strobe::stability {

using Picture = std::shared_ptr<const image::Image>;

// The right value of a channel of a pixel and how far the picture may be off it.
struct Right {
  double low, high, tolerance;
};
inline Right exactly(double value, double tolerance) { return {value, value, tolerance}; }

// Compares the three colours of each pixel for which `right` says something; reports the worst one. A value that is no
// number is infinitely far off.
using RightAt = std::function<std::optional<Right>(int x, int y, int channel)>;
Finding compare(const image::Image& picture, const RightAt& right, std::vector<lab::Shot> shots);

}  // namespace strobe::stability
