// SPDX-License-Identifier: MIT
// Fits a tree to boxes that have moved, for what bends from one time to the next: in a few passes over its nodes, where
// a build sorts all boxes.
#pragma once

#include "world/bvh.h"

namespace strobe::world {

// `bvh`: of buildBvh, with leaves that may have several boxes. `boxes`: as many as it was built over, in that order.
// Nodes, their children and `order` stay; bounds alone change, to those that a build of this topology would give, so
// that they depend on nothing that was before. `cost` stays that of the build. The more neighbours part, the more nodes
// a ray meets. Throws std::out_of_range where there are fewer boxes.
void refitBvh(Bvh& bvh, const std::vector<Box>& boxes);

}  // namespace strobe::world
