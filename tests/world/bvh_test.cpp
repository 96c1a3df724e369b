// SPDX-License-Identifier: MIT
// The runtime's BVH: properties of its nodes, on lists of boxes that are difficult for trees.
#include "world/bvh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <set>

namespace strobe::world {
namespace bvh_test {

using Boxes = std::vector<Box>;

Box around(const vec3& middle, const vec3& half) { return {middle - half, middle + half}; }

Boxes randomBoxes(size_t count, float size, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0, 1);
  auto any = [&] {
    float x = unit(random), y = unit(random);
    return vec3(x, y, unit(random));
  };
  Boxes boxes;
  for (size_t i = 0; i < count; ++i) boxes.push_back(around(any(), size * any()));
  return boxes;
}

// Triangles of a terrain, as in meshes: thin, flat, adjacent.
Boxes terrain(int side) {
  Boxes boxes;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int half = 0; half < 2; ++half) {
        Box box;
        for (int c = 0; c < 3; ++c) {
          float u = float(x + (c == 1 || half) * (c != 2)), v = float(y + (c == 2 || (half && c == 1)));
          box.add(vec3(u, 4 * std::sin(u / 9) * std::cos(v / 7), v));
        }
        boxes.push_back(box);
      }
  return boxes;
}

std::vector<std::pair<const char*, Boxes>> hardLists() {
  Boxes halving, nested;
  for (int i = 0; i < 300; ++i) {
    halving.push_back(around(vec3(std::ldexp(1.0f, -std::min(i, 120)), 0, 0), vec3(0)));
    nested.push_back(around(vec3(0), vec3(std::ldexp(1.0f, i / 4 - 30))));
  }
  Boxes mixed = randomBoxes(500, 0.01f);
  mixed.push_back(around(vec3(0), vec3(1e9f)));
  mixed.push_back(around(vec3(-1e17f), vec3(1)));
  return {{"one", randomBoxes(1, 1)},
          {"two", randomBoxes(2, 1)},
          {"five", randomBoxes(5, 1)},
          {"many", randomBoxes(3000, 0.02f)},
          {"in one place", Boxes(3000, around(vec3(1, 2, 3), vec3(0.5f)))},
          {"points in one place", Boxes(3000, around(vec3(7), vec3(0)))},
          {"each half as far", halving},
          {"one in another", nested},
          {"sizes far apart", mixed},
          {"terrain", terrain(40)},
          {"terrain for several threads", terrain(180)}};
}

// A tree with the numbers of its boxes in leaf order.
struct Tree : Bvh {
  std::vector<uint32_t> order;

  Boxes inOrder(const Boxes& boxes) const {
    Boxes sorted;
    for (uint32_t index : order) sorted.push_back(boxes[index]);
    return sorted;
  }
  void refit(const Boxes& boxes) { refitBvh(*this, inOrder(boxes)); }
};

Tree treeOf(const Boxes& boxes, const BvhOptions& options = {}) {
  std::vector<BvhItem> items;
  for (size_t i = 0; i < boxes.size(); ++i) items.push_back({boxes[i], uint32_t(i)});
  Tree tree{buildBvh(items, options), {}};
  for (const BvhItem& item : items) tree.order.push_back(item.index);
  return tree;
}

// A child's plane, computed as in the shader.
double planeOf(const shared::BvhNode& node, const uvec3& planes, int axis, int child) {
  double step = std::ldexp(1.0, int(node.steps >> (8 * axis) & 255) - 127);
  return double(node.origin[axis]) + step * (planes[axis] >> (8 * child) & 255);
}

struct Walk {
  const Tree& bvh;
  const Boxes& boxes;
  BvhOptions options;
  std::multiset<uint32_t> met;
  std::set<uint32_t> nodes;
  int deepest = 0;

  // Tests that every box lies between the planes of all nodes above it.
  Box down(uint32_t index, int depth) {
    Box whole;
    deepest = std::max(deepest, depth);
    EXPECT_TRUE(nodes.insert(index).second);
    const shared::BvhNode& node = bvh.nodes.at(index);
    for (int child = 0; child < int(node.steps >> 24); ++child) {
      uint32_t reference = node.children[child];
      Box box;
      if (reference & BVH_LEAF) {
        uint32_t count = options.leaf_boxes == 1 ? 1 : (reference >> BVH_LEAF_COUNT & 3) + 1;
        EXPECT_LE(count, options.leaf_boxes);
        for (uint32_t i = 0; i < count; ++i) {
          uint32_t one = options.leaf_boxes == 1 ? reference & ~BVH_LEAF
                                                 : bvh.order.at((reference & ((1u << BVH_LEAF_COUNT) - 1)) + i);
          met.insert(one);
          box.add(boxes.at(one));
        }
      } else {
        box = down(reference, depth + 1);
      }
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(planeOf(node, node.low, axis, child), box.low[axis]);
        EXPECT_GE(planeOf(node, node.high, axis, child), box.high[axis]);
      }
      whole.add(box);
    }
    return whole;
  }
};

TEST(Bvh, HasEveryBoxOnceWithinItsPlanes) {
  for (const BvhOptions& options : {BvhOptions{4, BVH_MESH_DEPTH}, BvhOptions{1, BVH_TOP_DEPTH}})
    for (const auto& [name, boxes] : hardLists()) {
      SCOPED_TRACE(name);
      Tree bvh = treeOf(boxes, options);
      Walk walk{bvh, boxes, options, {}, {}};
      walk.down(0, 1);
      EXPECT_EQ(walk.met.size(), boxes.size());
      EXPECT_EQ(std::set<uint32_t>(walk.met.begin(), walk.met.end()).size(), boxes.size());
      EXPECT_EQ(walk.nodes.size(), bvh.nodes.size());
      EXPECT_LE(walk.deepest, options.depth);
      EXPECT_LE(bvh.nodes.size(), std::max<size_t>(1, boxes.size()));
    }
}

TEST(Bvh, JoinedTreeHasEveryBoxOfBothOnce) {
  const BvhOptions options{1, BVH_TOP_DEPTH - 1};
  for (const auto& [name, boxes] : hardLists())
    for (size_t in_first : {size_t(0), size_t(1), boxes.size() / 3, boxes.size()}) {
      SCOPED_TRACE(fmt::format("{}, {} in the first", name, in_first));
      Boxes first = boxes, second = boxes;
      for (size_t i = 0; i < boxes.size(); ++i) (i < in_first ? second : first)[i] = Box();
      const Tree bvh{joined(buildBvh(first, options), buildBvh(second, options)), {}};
      Walk walk{bvh, boxes, options, {}, {}};
      EXPECT_EQ(walk.down(0, 1), bvh.bounds);
      EXPECT_EQ(walk.met.size(), boxes.size());
      EXPECT_EQ(std::set<uint32_t>(walk.met.begin(), walk.met.end()).size(), boxes.size());
      EXPECT_EQ(walk.nodes.size(), bvh.nodes.size());
      EXPECT_LE(walk.deepest, BVH_TOP_DEPTH);
      EXPECT_LE(bvh.nodes.size(), boxes.size() + 1);
    }
  EXPECT_EQ(joined(buildBvh(Boxes()), buildBvh(Boxes(3))).nodes.size(), 1u);
}

TEST(Bvh, EmptyTreeHasANodeWithoutChildren) {
  for (const Boxes& boxes : {Boxes(), Boxes(3)}) {
    Tree bvh = treeOf(boxes);
    ASSERT_EQ(bvh.nodes.size(), 1u);
    EXPECT_EQ(bvh.nodes[0].steps >> 24, 0u);
    EXPECT_TRUE(bvh.order.empty());
  }
}

TEST(Bvh, OmitsInvertedBoxes) {
  Boxes boxes = randomBoxes(9, 0.1f);
  boxes[4] = Box();
  Tree bvh = treeOf(boxes);
  EXPECT_EQ(bvh.order.size(), 8u);
  EXPECT_EQ(std::count(bvh.order.begin(), bvh.order.end(), 4u), 0);
}

TEST(Bvh, IsDeterministic) {
  Boxes boxes = randomBoxes(240000, 0.01f);
  Tree first = treeOf(boxes);
  for (int run = 0; run < 3; ++run) {
    Tree again = treeOf(boxes);
    ASSERT_EQ(again.order, first.order);
    ASSERT_EQ(std::memcmp(again.nodes.data(), first.nodes.data(), first.nodes.size() * sizeof first.nodes[0]), 0);
  }
}

// ---- Refitted trees

bool alike(const Tree& a, const Tree& b) {
  return a.order == b.order && a.nodes.size() == b.nodes.size() &&
         std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof a.nodes[0]) == 0;
}

TEST(Bvh, RefitToTheSameBoxesChangesNothing) {
  for (const auto& [name, boxes] : hardLists()) {
    Tree built = treeOf(boxes), fitted = built;
    fitted.refit(boxes);
    EXPECT_TRUE(alike(fitted, built)) << name;
    EXPECT_EQ(fitted.bounds, built.bounds) << name;
  }
  Bvh nothing = buildBvh(Boxes());
  refitBvh(nothing, {});
  EXPECT_EQ(nothing.nodes.size(), 1u);
}

// Moves boxes like a deforming skin: each along its own direction, similar for neighbours.
Boxes bent(const Boxes& boxes, float by) {
  Boxes moved;
  for (const Box& box : boxes) {
    vec3 middle = 0.5f * (box.low + box.high), half = 0.5f * (box.high - box.low);
    vec3 way(std::sin(3 * middle.y), std::sin(2 * middle.z), std::cos(5 * middle.x));
    moved.push_back(around(middle + by * way, half * 1.25f));
  }
  return moved;
}

struct Line {
  dvec3 origin, direction;
  // Distance along the line to its entry between two planes per axis; infinity if the line misses.
  double enters(const dvec3& low, const dvec3& high) const {
    double enter = 0, leave = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis) {
      double a = (low[axis] - origin[axis]) / direction[axis], b = (high[axis] - origin[axis]) / direction[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave ? enter : HUGE_VAL;
  }
  double enters(const Box& box) const { return enters(dvec3(box.low), dvec3(box.high)); }
};

// Distance along a line to its first entry into a box, found by traversing the tree.
double nearest(const Tree& bvh, const Boxes& boxes, const Line& line, uint32_t index = 0) {
  const shared::BvhNode& node = bvh.nodes.at(index);
  double found = HUGE_VAL;
  for (int child = 0; child < int(node.steps >> 24); ++child) {
    dvec3 low, high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = planeOf(node, node.low, axis, child);
      high[axis] = planeOf(node, node.high, axis, child);
    }
    if (line.enters(low, high) == HUGE_VAL) continue;
    uint32_t reference = node.children[child];
    if (!(reference & BVH_LEAF)) found = std::min(found, nearest(bvh, boxes, line, reference));
    else
      for (uint32_t i = 0; i <= (reference >> BVH_LEAF_COUNT & 3); ++i)
        found = std::min(found, line.enters(boxes.at(bvh.order.at((reference & ((1u << BVH_LEAF_COUNT) - 1)) + i))));
  }
  return found;
}

TEST(Bvh, RefittedTreeFindsTheHitsOfARebuiltTree) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  auto any = [&] {
    double x = unit(random), y = unit(random);
    return dvec3(x, y, unit(random));
  };
  for (const Boxes& boxes : {randomBoxes(3000, 0.02f), terrain(30)}) {
    Tree fitted = treeOf(boxes);
    for (float by : {0.1f, 2.0f, 0.0f}) {
      Boxes moved = bent(boxes, by);
      fitted.refit(moved);
      Walk walk{fitted, moved, {}, {}, {}};
      walk.down(0, 1);
      EXPECT_EQ(walk.met.size(), boxes.size());
      Tree rebuilt = treeOf(moved);
      int hits = 0;
      for (int i = 0; i < 2000; ++i) {
        const Box& aim = moved[size_t(i) % moved.size()];
        Line line{20.0 * any(), {}};
        line.direction = 0.5 * (dvec3(aim.low) + dvec3(aim.high)) - line.origin;
        double met = nearest(fitted, moved, line), all = HUGE_VAL;
        for (const Box& box : moved) all = std::min(all, line.enters(box));
        EXPECT_EQ(met, all);
        EXPECT_EQ(met, nearest(rebuilt, moved, line));
        hits += met < HUGE_VAL;
      }
      EXPECT_EQ(hits, 2000);
    }
  }
}

TEST(Bvh, RefitIsDeterministicAndKeepsTheTopology) {
  Boxes boxes = randomBoxes(5000, 0.01f), moved = bent(boxes, 0.5f);
  Tree built = treeOf(boxes), once = built, by_a_way_round = built;
  once.refit(moved);
  by_a_way_round.refit(bent(boxes, 3));
  by_a_way_round.refit(moved);
  EXPECT_TRUE(alike(once, by_a_way_round));
  ASSERT_EQ(once.nodes.size(), built.nodes.size());
  for (size_t i = 0; i < built.nodes.size(); ++i)
    EXPECT_EQ(std::memcmp(once.nodes[i].children, built.nodes[i].children, sizeof built.nodes[i].children), 0);
}

}  // namespace bvh_test
}  // namespace strobe::world
