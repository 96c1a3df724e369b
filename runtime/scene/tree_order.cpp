// SPDX-License-Identifier: MIT
#include "scene/tree_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <future>
#include <thread>

#include "scene/bend.h"

namespace strobe::scene {

namespace {

double areaOf(const Bounds& box) {
  if (box.empty()) return 0;
  dvec3 size = box.high - box.low;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

// Size of the first half of a list of `count`.
size_t halfOf(size_t count) { return (count - 1) / 2 + 1; }

struct Item {
  std::array<float, 3> low, high;
  uint32_t index;

  float twiceMiddle(int axis) const { return low[size_t(axis)] + high[size_t(axis)]; }
};

struct Sides {
  std::array<float, 3> low = {HUGE_VALF, HUGE_VALF, HUGE_VALF}, high = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};
  size_t count = 0;
  void add(const Item& item) {
    for (size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], item.low[axis]);
      high[axis] = std::max(high[axis], item.high[axis]);
    }
    ++count;
  }
  double cost() const {
    double x = double(high[0]) - low[0], y = double(high[1]) - low[1], z = double(high[2]) - low[2];
    return (x * y + y * z + z * x) * double(count);
  }
};

// Sort key of an item along an axis, ties by index.
uint64_t placeOf(const Item& item, int axis) {
  const uint32_t bits = std::bit_cast<uint32_t>(item.twiceMiddle(axis) + 0.0f);  // -0 becomes 0
  const uint32_t ordered = bits & 0x80000000u ? ~bits : bits | 0x80000000u;
  return uint64_t(ordered) << 32 | item.index;
}

class Halving {
 public:
  Halving(std::vector<Item>& items, const std::vector<size_t>& ends) : items_(items), ends_(ends) {}

  // The items of each list are fixed before its halves are ordered, so that any number of threads gives the same order.
  void order(size_t begin, size_t end, unsigned threads) {
    std::vector<uint64_t> places(end - begin);
    order(begin, end, threads, places);
  }

 private:
  static constexpr size_t kWorthAThread = 10000;

  void order(size_t begin, size_t end, unsigned threads, std::vector<uint64_t>& places) {
    if (end - begin < 2) return;
    size_t middle = begin + halfOf(end - begin);
    // Part of this list in the group that contains its middle.
    size_t group = size_t(std::upper_bound(ends_.begin(), ends_.end(), middle - 1) - ends_.begin());
    size_t first = std::max(begin, group == 0 ? 0 : ends_[group - 1]), last = std::min(end, ends_[group]);
    if (middle < last) halve(first, middle, last, places);
    std::future<void> left;
    if (threads > 1 && end - begin > kWorthAThread)
      left = std::async(std::launch::async, [=, this] { order(begin, middle, threads / 2); });
    else order(begin, middle, 1, places);
    order(middle, end, threads - threads / 2, places);
    if (left.valid()) left.get();
  }

  // Sort key of the first item of the second half. `places` has room for one key per item.
  uint64_t middlePlace(size_t first, size_t middle, size_t last, int axis, std::vector<uint64_t>& places) const {
    for (size_t i = first; i < last; ++i) places[i - first] = placeOf(items_[i], axis);
    auto begin = places.begin(), at = begin + std::ptrdiff_t(middle - first);
    std::nth_element(begin, at, begin + std::ptrdiff_t(last - first));
    return *at;
  }

  void halve(size_t first, size_t middle, size_t last, std::vector<uint64_t>& places) {
    double best = 0;
    int best_axis = -1;
    uint64_t best_place = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const uint64_t place = middlePlace(first, middle, last, axis, places);
      std::array<Sides, 2> sides;
      for (size_t i = first; i < last; ++i) sides[placeOf(items_[i], axis) >= place].add(items_[i]);
      const double cost = sides[0].cost() + sides[1].cost();
      if (best_axis < 0 || cost < best) best = cost, best_axis = axis, best_place = place;
    }
    std::partition(items_.begin() + std::ptrdiff_t(first), items_.begin() + std::ptrdiff_t(last),
                   [&](const Item& item) { return placeOf(item, best_axis) < best_place; });
  }

  std::vector<Item>& items_;
  const std::vector<size_t>& ends_;
};

// Adds the areas of all boxes of the tree over a list to `areas`. Returns the outermost box.
Bounds addAreas(const std::vector<Bounds>& boxes, size_t begin, size_t end, double& areas) {
  Bounds bounds;
  if (end - begin == 1) bounds = boxes[begin];
  else {
    size_t middle = begin + halfOf(end - begin);
    bounds = addAreas(boxes, begin, middle, areas);
    bounds.add(addAreas(boxes, middle, end, areas));
  }
  areas += areaOf(bounds);
  return bounds;
}

std::vector<Bounds> trianglesOf(const Mesh& mesh, bool as_given = false) {
  std::vector<Bounds> boxes;
  for (const Geometry& geometry : mesh.geometries) {
    const size_t first = boxes.size(), triangles = geometry.indices.size() / 3;
    boxes.resize(first + triangles);
    for (size_t i = 0; i < triangles; ++i) {
      Bounds& box = boxes[first + (as_given ? sourceTriangle(geometry, uint32_t(i)) : i)];
      for (size_t corner = 0; corner < 3; ++corner)
        box.add(dvec3(geometry.vertices[geometry.indices[3 * i + corner]].position));
    }
  }
  return boxes;
}

}  // namespace

static Item itemOf(const Bounds& bounds, size_t index) {
  const Bounds box = bounds.empty() ? Bounds{dvec3(0), dvec3(0)} : bounds;
  Item item;
  item.index = uint32_t(index);
  for (int axis = 0; axis < 3; ++axis)
    item.low[size_t(axis)] = float(box.low[axis]), item.high[size_t(axis)] = float(box.high[axis]);
  return item;
}

static void orderItems(std::vector<Item>& items, const std::vector<size_t>& ends) {
  Halving(items, ends).order(0, items.size(), std::max(1u, std::thread::hardware_concurrency()));
}

std::vector<uint32_t> treeOrder(const std::vector<Bounds>& boxes, const std::vector<size_t>& ends) {
  std::vector<Item> items;
  for (const Bounds& box : boxes) items.push_back(itemOf(box, items.size()));
  orderItems(items, ends);
  std::vector<uint32_t> order;
  for (const Item& item : items) order.push_back(item.index);
  return order;
}

// Boxes of the triangles of a mesh, numbered across its geometries.
static std::vector<Item> itemsOf(const Mesh& mesh, size_t count) {
  std::vector<Item> items;
  items.reserve(count);
  for (const Geometry& geometry : mesh.geometries)
    for (size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
      Bounds box;
      for (size_t corner = 0; corner < 3; ++corner)
        box.add(dvec3(geometry.vertices[geometry.indices[i + corner]].position));
      items.push_back(itemOf(box, items.size()));
    }
  return items;
}

void orderTriangles(Scene& scene) {
  for (Mesh& mesh : scene.meshes) {
    for (const Geometry& geometry : mesh.geometries) STROBE_ASSERT(geometry.source.empty(), "{}", mesh.name);
    std::vector<size_t> ends;
    size_t count = 0;
    for (const Geometry& geometry : mesh.geometries) ends.push_back(count += geometry.indices.size() / 3);
    std::vector<Item> items = itemsOf(mesh, count);
    orderItems(items, ends);
    size_t at = 0;
    for (Geometry& geometry : mesh.geometries) {
      const size_t first = at, triangles = geometry.indices.size() / 3;
      std::vector<uint32_t> indices;
      indices.reserve(geometry.indices.size());
      geometry.source.reserve(triangles);
      for (size_t i = 0; i < triangles; ++i) {
        size_t source = items[at++].index - first;
        geometry.source.push_back(uint32_t(source));
        indices.insert(indices.end(), geometry.indices.begin() + long(3 * source),
                       geometry.indices.begin() + long(3 * source + 3));
      }
      geometry.indices = std::move(indices);
    }
  }
}

uint32_t sourceTriangle(const Geometry& geometry, uint32_t triangle) {
  return triangle < geometry.source.size() ? geometry.source[triangle] : triangle;
}

uint32_t sourceTriangle(const Scene& scene, const std::vector<Instance>& instances, uint32_t instance,
                        uint32_t geometry, uint32_t triangle) {
  if (instance == 0 || instance > instances.size()) return triangle;
  const std::vector<Geometry>& geometries = scene.meshes[size_t(instances[instance - 1].mesh)].geometries;
  return geometry < geometries.size() ? sourceTriangle(geometries[geometry], triangle) : triangle;
}

double treeCost(const std::vector<Bounds>& boxes) {
  if (boxes.empty()) return 0;
  double areas = 0;
  double whole = areaOf(addAreas(boxes, 0, boxes.size(), areas));
  return whole > 0 ? areas / whole : 1;
}

Bounds moved(const Bounds& box, const dmat4& transform) {
  Bounds result;
  for (int i = 0; i < 8 && !box.empty(); ++i) result.add(dvec3(transform * dvec4(box.corner(i), 1)));
  return result;
}

SceneTree treeOf(const Scene& scene, const Pose& pose) {
  SceneTree tree;
  struct OfMesh {
    Bounds bounds;
    size_t triangles = 0;
    double visits = 0, visits_as_given = 0;
  };
  std::vector<OfMesh> meshes;
  for (const Mesh& mesh : scene.meshes) {
    std::vector<Bounds> boxes = trianglesOf(mesh);
    meshes.push_back({{}, boxes.size(), treeCost(boxes), treeCost(trianglesOf(mesh, true))});
    for (const Bounds& box : boxes) meshes.back().bounds.add(box);
  }
  std::vector<Instance> instances = instancesOf(scene);
  std::vector<Bounds> boxes;
  for (size_t i = 0; i < instances.size(); ++i)
    boxes.push_back(bends(scene, instances[i])
                        ? posedBounds(scene, instances, i, pose)
                        : moved(meshes[size_t(instances[i].mesh)].bounds, pose.world_from_instance[i]));
  tree.instances = instances.size(), tree.visits = tree.visits_as_given = treeCost(boxes);
  Bounds whole;
  for (const Bounds& box : boxes) whole.add(box);
  for (size_t i = 0; i < instances.size(); ++i) {
    const OfMesh& mesh = meshes[size_t(instances[i].mesh)];
    tree.triangles += mesh.triangles;
    const double share = areaOf(whole) > 0 ? areaOf(boxes[i]) / areaOf(whole) : 1;
    tree.visits += share * mesh.visits, tree.visits_as_given += share * mesh.visits_as_given;
  }
  return tree;
}

}  // namespace strobe::scene
