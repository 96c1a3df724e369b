// SPDX-License-Identifier: MIT
// Colour map of error maps and heat maps: black, violet, orange, pale yellow; perceptually uniform.
#pragma once

#include <array>

namespace strobe::image {

using Colour = std::array<float, 3>;  // display values (sRGB-encoded) in [0,1]

// `value` is clamped to [0,1] (NaN to 0) and rounded to one of 256 steps.
Colour magma(float value);

}  // namespace strobe::image
