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

// A bounding volume hierarchy with up to four children per node, with the leaf order of its boxes.
struct Bvh {
  std::vector<shared::BvhNode> nodes;  // root first, then depth first
  std::vector<uint32_t> order;         // box indices in leaf order
  Box bounds;
};

// Limits of a tree build: boxes per leaf, 1 to 4, and depth.
struct BvhOptions {
  uint32_t leaf_boxes = 4;  // maximum boxes per leaf, 1 to 4
  int depth = BVH_MESH_DEPTH;
};

// Builds a tree. With several boxes per leaf, leaves refer to `order` (BVH_LEAF in shared/bvh.h); with one, a leaf is
// BVH_LEAF | box index. Boxes must be finite; inverted boxes are skipped. A tree without boxes has one node without
// children.
Bvh buildBvh(const std::vector<Box>& boxes, const BvhOptions& options = {});
// Builds a tree over items with any indices, and sorts the items into leaf order; `order` stays empty.
Bvh buildBvh(std::vector<BvhItem>& items, const BvhOptions& options = {});
// Joins two trees with one box per leaf under a new root; the depth is one more than the depth of the deeper tree.
// `order` stays empty.
Bvh joined(const Bvh& a, const Bvh& b);

}  // namespace strobe::world
