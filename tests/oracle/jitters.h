// SPDX-License-Identifier: MIT
// The filters' jitters, implemented again from their definitions: in [-1/2, 1/2), a function of the pixel.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace strobe::oracle {

using JitterAt = std::function<double(int x, int y)>;

// Interleaved gradient noise (Jimenez 2014).
double ignJitter(int x, int y);

// All jitters except `none`, by name. `frame` is the frame number for a jitter that changes per frame, else 0.
std::vector<std::pair<std::string, JitterAt>> jittersOf(uint32_t frame = 0, uint32_t seed = 0);

}  // namespace strobe::oracle
