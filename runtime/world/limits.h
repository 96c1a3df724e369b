// SPDX-License-Identifier: MIT
// Limits of the runtime's own trees.
#pragma once

#include <array>

#include "base/limit.h"

namespace strobe::world {

inline constexpr Limit kTreeLimit{
    "tree", Limit::Kind::Refused,
    "tracing backend `bvh`: a scene has more triangles, instances or nodes of its tree than it can number",
    "nothing is drawn; take fewer, or `--backend query` or `pipeline` on a device that has it"};

inline constexpr std::array kLimits = {kTreeLimit};

}  // namespace strobe::world
