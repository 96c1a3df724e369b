// SPDX-License-Identifier: MIT
// Refits a tree to boxes that have moved, for deformed meshes. A refit is a pass over the nodes; a build sorts all
// boxes.
#pragma once

#include "world/bvh.h"

namespace strobe::world {

// `bvh`: from buildBvh, with leaves of several boxes. `boxes`: number and order as in the build. Nodes, children and
// `order` stay. Only the bounds change, to the bounds that a build with this topology would give, so a refit does not
// depend on earlier refits. Rays meet more nodes as neighbours separate. Throws std::out_of_range if there are fewer
// boxes.
void refitBvh(Bvh& bvh, const std::vector<Box>& boxes);

}  // namespace strobe::world
