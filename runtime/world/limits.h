// SPDX-License-Identifier: MIT
// Limits of the runtime's own trees.
#pragma once

#include <array>

#include "base/limit.h"

namespace strobe::world {

inline constexpr Limit kTreeLimit{
    "tree", Limit::Kind::Refused,
    "tracing backend `bvh`: a scene has more triangles, instances or tree nodes than the tree can number",
    "nothing is drawn; use a smaller scene, or `--backend query` or `pipeline` on a device that has it"};

inline constexpr std::array kLimits = {kTreeLimit};

}  // namespace strobe::world
