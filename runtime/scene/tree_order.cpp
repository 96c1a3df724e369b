// SPDX-License-Identifier: MIT
#include "scene/tree_order.h"

#include <algorithm>
#include <array>
#include <future>
#include <thread>

namespace strobe::scene {

namespace {

double areaOf(const Bounds& box) {
  if (box.empty()) return 0;
  dvec3 size = box.high - box.low;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

// Of a list of `count` the first half has so many.
size_t halfOf(size_t count) { return (count - 1) / 2 + 1; }

struct Item {
  std::array<float, 3> low, high;
  uint32_t index;

  float twiceMiddle(int axis) const { return low[size_t(axis)] + high[size_t(axis)]; }
};

double costOf(const Item* begin, const Item* end) {
  std::array<float, 3> low = begin->low, high = begin->high;
  for (const Item* item = begin + 1; item < end; ++item)
    for (size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], item->low[axis]);
      high[axis] = std::max(high[axis], item->high[axis]);
    }
  double x = double(high[0]) - low[0], y = double(high[1]) - low[1], z = double(high[2]) - low[2];
  return (x * y + y * z + z * x) * double(end - begin);
}

class Halving {
 public:
  Halving(std::vector<Item>& items, const std::vector<size_t>& ends) : items_(items), ends_(ends) {}

  // Which items a list has is decided before its halves are looked at: any number of threads leaves the same order.
  void order(size_t begin, size_t end, unsigned threads) {
    if (end - begin < 2) return;
    size_t middle = begin + halfOf(end - begin);
    // What lies in this list of the group that its middle falls into.
    size_t group = size_t(std::upper_bound(ends_.begin(), ends_.end(), middle - 1) - ends_.begin());
    size_t first = std::max(begin, group == 0 ? 0 : ends_[group - 1]), last = std::min(end, ends_[group]);
    if (middle < last) halve(first, middle, last);
    std::future<void> left;
    if (threads > 1 && end - begin > kWorthAThread)
      left = std::async(std::launch::async, [=, this] { order(begin, middle, threads / 2); });
    else order(begin, middle, 1);
    order(middle, end, threads - threads / 2);
    if (left.valid()) left.get();
  }

 private:
  static constexpr size_t kWorthAThread = 10000;

  void halve(size_t first, size_t middle, size_t last) {
    auto at = [this](size_t i) { return items_.begin() + std::ptrdiff_t(i); };
    auto halveOn = [&](int axis) {
      std::nth_element(at(first), at(middle), at(last), [axis](const Item& a, const Item& b) {
        float left = a.twiceMiddle(axis), right = b.twiceMiddle(axis);
        return left < right || (left == right && a.index < b.index);
      });
    };
    double best = 0;
    int best_axis = -1;
    for (int axis = 0; axis < 3; ++axis) {
      halveOn(axis);
      const Item* items = items_.data();
      double cost = costOf(items + first, items + middle) + costOf(items + middle, items + last);
      if (best_axis < 0 || cost < best) best = cost, best_axis = axis;
    }
    if (best_axis != 2) halveOn(best_axis);
  }

  std::vector<Item>& items_;
  const std::vector<size_t>& ends_;
};

// Adds the areas of all boxes of the tree over a list; returns the outermost.
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

std::vector<uint32_t> treeOrder(const std::vector<Bounds>& boxes, const std::vector<size_t>& ends) {
  std::vector<Item> items(boxes.size());
  for (size_t i = 0; i < boxes.size(); ++i) {
    Bounds box = boxes[i].empty() ? Bounds{dvec3(0), dvec3(0)} : boxes[i];
    items[i].index = uint32_t(i);
    for (int axis = 0; axis < 3; ++axis)
      items[i].low[size_t(axis)] = float(box.low[axis]), items[i].high[size_t(axis)] = float(box.high[axis]);
  }
  Halving(items, ends).order(0, items.size(), std::max(1u, std::thread::hardware_concurrency()));
  std::vector<uint32_t> order;
  for (const Item& item : items) order.push_back(item.index);
  return order;
}

void orderTriangles(Scene& scene) {
  for (Mesh& mesh : scene.meshes) {
    for (const Geometry& geometry : mesh.geometries) STROBE_ASSERT(geometry.source.empty(), "{}", mesh.name);
    std::vector<size_t> ends;
    size_t count = 0;
    for (const Geometry& geometry : mesh.geometries) ends.push_back(count += geometry.indices.size() / 3);
    const std::vector<uint32_t> order = treeOrder(trianglesOf(mesh), ends);
    size_t at = 0;
    for (Geometry& geometry : mesh.geometries) {
      const size_t first = at, triangles = geometry.indices.size() / 3;
      std::vector<uint32_t> indices;
      for (size_t i = 0; i < triangles; ++i) {
        size_t source = order[at++] - first;
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

SceneTree treeOf(const Scene& scene, const std::vector<dmat4>& world_from_instance) {
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
    boxes.push_back(moved(meshes[size_t(instances[i].mesh)].bounds, world_from_instance[i]));
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
