// SPDX-License-Identifier: MIT
// The order of triangles: a permutation that keeps to its groups, the same always, and a tree nearly as cheap as one
// made by the surface area heuristic.
#include "scene/tree_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace strobe::scene {
namespace tree_order_test {

Bounds unitBox(double x, double y = 0, double z = 0) {
  Bounds box;
  box.add(dvec3(x, y, z));
  box.add(dvec3(x + 1, y + 1, z + 1));
  return box;
}

std::vector<Bounds> permuted(const std::vector<Bounds>& boxes, const std::vector<uint32_t>& order) {
  std::vector<Bounds> result;
  for (uint32_t i : order) result.push_back(boxes[i]);
  return result;
}

// Any tree over boxes, made by trying every cut on every axis: the least sum of areas times counts, top down.
double heuristicCost(std::vector<Bounds> boxes) {
  auto area = [](const Bounds& box) {
    dvec3 size = box.high - box.low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
  };
  struct Tree {
    decltype(area)& areaOf;
    double areas = 0;
    void add(std::vector<Bounds> boxes) {
      Bounds all;
      for (const Bounds& box : boxes) all.add(box);
      areas += areaOf(all);
      if (boxes.size() == 1) return;
      double best = HUGE_VAL;
      std::vector<Bounds> left, right;
      for (int axis = 0; axis < 3; ++axis) {
        std::stable_sort(boxes.begin(), boxes.end(),
                         [axis](const Bounds& a, const Bounds& b) { return a.middle()[axis] < b.middle()[axis]; });
        std::vector<double> from_right(boxes.size());
        Bounds some;
        for (size_t i = boxes.size(); i-- > 1;)
          some.add(boxes[i]), from_right[i] = areaOf(some) * double(boxes.size() - i);
        some = Bounds();
        for (size_t i = 1; i < boxes.size(); ++i) {
          some.add(boxes[i - 1]);
          double cost = areaOf(some) * double(i) + from_right[i];
          if (cost >= best) continue;
          best = cost;
          left.assign(boxes.begin(), boxes.begin() + long(i)), right.assign(boxes.begin() + long(i), boxes.end());
        }
      }
      add(left), add(right);
    }
  } tree{area};
  Bounds all;
  for (const Bounds& box : boxes) all.add(box);
  tree.add(std::move(boxes));
  return tree.areas / area(all);
}

TEST(TreeOrder, SortsARow) {
  std::vector<Bounds> boxes;
  for (double x : {7., 2., 5., 0., 6., 3., 1., 4., 8.}) boxes.push_back(unitBox(10 * x));
  std::vector<Bounds> sorted = permuted(boxes, treeOrder(boxes, {boxes.size()}));
  for (size_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i].low.x, 10. * double(i));
}

// Two boxes of a row: the outermost, and each by itself. In units of the outermost: 1 + 2 * 3 / (2 + 2 + 1).
TEST(TreeOrder, CostHasAClosedForm) {
  EXPECT_EQ(treeCost({}), 0);
  EXPECT_EQ(treeCost({unitBox(0)}), 1);
  EXPECT_DOUBLE_EQ(treeCost({unitBox(0), unitBox(1)}), 1 + 2 * 3 / 5.0);
  // Four of a row, as they lie: 1 + 2 * 5/9 + 4 * 3/9; the first and third exchanged: halves of 3 units each.
  EXPECT_DOUBLE_EQ(treeCost({unitBox(0), unitBox(1), unitBox(2), unitBox(3)}), 1 + 2 * 5 / 9. + 4 * 3 / 9.);
  EXPECT_DOUBLE_EQ(treeCost({unitBox(2), unitBox(1), unitBox(0), unitBox(3)}), 1 + 5 / 9. + 1 + 4 * 3 / 9.);
}

TEST(TreeOrder, IsAPermutationThatKeepsToItsGroups) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<Bounds> boxes;
    std::vector<size_t> ends;
    for (size_t group = random() % 4 + 1; group > 0; --group) {
      for (size_t i = random() % 9; i > 0; --i) boxes.push_back(unitBox(random() % 4, random() % 3, random() % 3));
      ends.push_back(boxes.size());
    }
    if (boxes.empty()) continue;
    std::vector<uint32_t> order = treeOrder(boxes, ends);
    size_t begin = 0;
    for (size_t end : ends) {
      std::set<uint32_t> group(order.begin() + long(begin), order.begin() + long(end));
      ASSERT_EQ(group.size(), end - begin);
      if (end > begin) {
        EXPECT_EQ(*group.begin(), begin);
        EXPECT_EQ(*group.rbegin(), end - 1);
      }
      begin = end;
    }
    EXPECT_EQ(treeOrder(boxes, ends), order);
  }
}

// Small boxes on a bumpy surface, shuffled.
TEST(TreeOrder, CostsLittleMoreThanByTheHeuristic) {
  std::mt19937 random(2);
  std::vector<Bounds> boxes;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) boxes.push_back(unitBox(x, y, 5 * std::sin(0.3 * x) * std::cos(0.2 * y)));
  std::shuffle(boxes.begin(), boxes.end(), random);
  double given = treeCost(boxes), ordered = treeCost(permuted(boxes, treeOrder(boxes, {boxes.size()})));
  double best = heuristicCost(boxes);
  EXPECT_LT(ordered, 1.3 * best);
  EXPECT_GT(given, 5 * ordered);
}

// Many enough for several threads.
TEST(TreeOrder, OfASceneKeepsWhatEachTriangleWas) {
  Scene scene;
  std::mt19937 random(3);
  for (size_t count : {30000u, 7u, 0u}) {
    Geometry& geometry = scene.meshes.emplace_back().geometries.emplace_back();
    for (size_t i = 0; i < 3 * count; ++i) {
      Vertex vertex{};
      vertex.position = vec3(random() % 1000, random() % 1000, random() % 1000) * 0.01f;
      geometry.vertices.push_back(vertex);
      geometry.indices.push_back(uint32_t(i));
    }
  }
  scene.meshes[1].geometries.push_back(scene.meshes[1].geometries[0]);
  Scene ordered = scene, again = scene;
  orderTriangles(ordered), orderTriangles(again);
  for (size_t m = 0; m < scene.meshes.size(); ++m)
    for (size_t g = 0; g < scene.meshes[m].geometries.size(); ++g) {
      const Geometry &was = scene.meshes[m].geometries[g], &is = ordered.meshes[m].geometries[g];
      EXPECT_EQ(again.meshes[m].geometries[g].indices, is.indices);
      ASSERT_EQ(is.indices.size(), was.indices.size());
      for (uint32_t i = 0; i < is.indices.size(); ++i)
        ASSERT_EQ(is.indices[i], was.indices[3 * sourceTriangle(is, i / 3) + i % 3]);
      EXPECT_EQ(std::set<uint32_t>(is.source.begin(), is.source.end()).size(), is.source.size());
    }
  EXPECT_EQ(sourceTriangle(scene.meshes[0].geometries[0], 5), 5u) << "as given";
}

TEST(TreeOrder, TrianglesAreFoundByWhatTheDeviceCallsThem) {
  Scene scene;
  for (uint32_t mesh = 0; mesh < 2; ++mesh) {
    scene.meshes.emplace_back().geometries.resize(2);
    for (uint32_t g = 0; g < 2; ++g) scene.meshes[mesh].geometries[g].source = {9 + 10 * g + 100 * mesh, 1};
  }
  const std::vector<Instance> instances = {{0, 1}, {1, 0}};
  EXPECT_EQ(sourceTriangle(scene, instances, 1, 0, 0), 109u);
  EXPECT_EQ(sourceTriangle(scene, instances, 2, 1, 0), 19u);
  EXPECT_EQ(sourceTriangle(scene, instances, 2, 1, 1), 1u);
  EXPECT_EQ(sourceTriangle(scene, instances, 0, 0, 0), 0u) << "nothing is there";
  EXPECT_EQ(sourceTriangle(scene, instances, 3, 0, 0), 0u) << "no such instance";
  EXPECT_EQ(sourceTriangle(scene, instances, 1, 2, 0), 0u) << "no such geometry";
}

}  // namespace tree_order_test
}  // namespace strobe::scene
