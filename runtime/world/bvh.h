// SPDX-License-Identifier: MIT
// Builds trees over boxes by the surface area heuristic (MacDonald and Booth 1990), binned (Wald 2007), and joins two
// levels each to nodes of four children. The same tree for any number of threads.
#pragma once

#include <vector>

#include "math/geometry.h"
#include "shared/bvh.h"

namespace strobe::world {

struct Box {
  vec3 low = vec3(HUGE_VALF), high = vec3(-HUGE_VALF);
  void add(const vec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  void add(const Box& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  bool operator==(const Box&) const = default;
};

struct BvhItem {
  Box box;
  uint32_t index = 0;
};

struct Bvh {
  std::vector<shared::BvhNode> nodes;  // the root first, then depth first
  std::vector<uint32_t> order;         // boxes as leaves have them
  // Expected cost of a random line that meets the root: a node costs 1, a box in a leaf 1; before levels are joined.
  double cost = 0;
  Box bounds;
};

struct BvhOptions {
  uint32_t leaf_boxes = 4;  // at most, up to 4
  int depth = BVH_MESH_DEPTH;
};

// Leaves refer to `order`: with several boxes to a leaf as BVH_LEAF says, with one as BVH_LEAF | order[i] itself. Boxes
// must be finite; those that are inside out are left out. Without any the tree has one node without children.
Bvh buildBvh(const std::vector<Box>& boxes, const BvhOptions& options = {});
// The same of items of different indices, which are left as leaves have them; `order` stays empty.
Bvh buildBvh(std::vector<BvhItem>& items, const BvhOptions& options = {});
// One tree over two with one box to a leaf, as deep as the deeper and a node on top. `order` stays empty, and `cost` 0.
Bvh joined(const Bvh& a, const Bvh& b);

}  // namespace strobe::world
