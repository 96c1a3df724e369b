// SPDX-License-Identifier: MIT
// Builds trees over boxes by the surface area heuristic (MacDonald and Booth 1990), binned (Wald 2007), with four
// children per node. The tree does not depend on the number of threads.
#pragma once

#include <vector>

#include "math/bounds.h"
#include "shared/bvh.h"

namespace strobe::world {

// Axis-aligned box in single precision.
using Box = BoundsOf<vec3>;

// A box to put into a tree, with the index that its leaf stores.
struct BvhItem {
  Box box;
  uint32_t index = 0;
};

// A bounding volume hierarchy with up to four children per node.
struct Bvh {
  std::vector<shared::BvhNode> nodes;  // root first, then depth first
  Box bounds;
};

// Limits of a tree build: boxes per leaf, 1 to 4, and depth.
struct BvhOptions {
  uint32_t leaf_boxes = 4;  // maximum boxes per leaf, 1 to 4
  int depth = BVH_MESH_DEPTH;
};

// Builds a tree and sorts the items into leaf order. With several boxes per leaf, leaves refer to this order (BVH_LEAF
// in shared/bvh.h); with one, a leaf is BVH_LEAF | index of the item. Boxes must be finite; items with inverted boxes
// are removed. A tree without boxes has one node without children.
Bvh buildBvh(std::vector<BvhItem>& items, const BvhOptions& options = {});
// Builds a tree over boxes with their places as indices.
Bvh buildBvh(const std::vector<Box>& boxes, const BvhOptions& options = {});
// Refits a tree to boxes that have moved, for deformed meshes. A refit is a pass over the nodes; a build sorts all
// boxes. `bvh`: with leaves of several boxes. `boxes`: in leaf order. Nodes and children stay. Only the bounds change,
// to the bounds that a build with this topology would give, so a refit does not depend on earlier refits. Rays meet
// more nodes as neighbours separate. Throws std::out_of_range if there are fewer boxes than in the build.
void refitBvh(Bvh& bvh, const std::vector<Box>& boxes);
// Joins two trees with one box per leaf under a new root; the depth is one more than the depth of the deeper tree.
Bvh joined(const Bvh& a, const Bvh& b);

}  // namespace strobe::world
