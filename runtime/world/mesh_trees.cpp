// SPDX-License-Identifier: MIT
#include "world/mesh_trees.h"

#include <algorithm>

#include "base/error.h"

namespace strobe::world {

using shared::BvhNode;
using shared::BvhTriangle;

namespace {

Box boxOf(const BvhTriangle& triangle) {
  Box box;
  for (const vec3& corner : triangle.corner) box.add(corner);
  return box;
}

// The triangles of a mesh, numbered across its geometries.
class Triangles {
 public:
  Triangles(const scene::Scene& scene, const scene::Mesh& mesh) : scene_(scene), mesh_(mesh) {
    for (const scene::Geometry& geometry : mesh.geometries) {
      firsts_.push_back(count_);
      count_ += uint32_t(geometry.indices.size() / 3);
    }
  }

  uint32_t count() const { return count_; }

  std::vector<BvhItem> items() const {
    std::vector<BvhItem> items;
    items.reserve(count_);
    for (uint32_t i = 0; i < count_; ++i) items.push_back({boxOf(at(i)), i});
    return items;
  }

  // Vertices of a triangle, numbered across the geometries.
  std::array<uint32_t, 3> verticesOf(uint32_t index) const {
    const size_t g = geometryOf(index);
    uint32_t first = 0;
    for (size_t before = 0; before < g; ++before) first += uint32_t(mesh_.geometries[before].vertices.size());
    const uint32_t* corner = &mesh_.geometries[g].indices[3 * size_t(index - firsts_[g])];
    return {first + corner[0], first + corner[1], first + corner[2]};
  }

  BvhTriangle at(uint32_t index) const {
    const size_t g = geometryOf(index);
    const scene::Geometry& geometry = mesh_.geometries[g];
    const scene::Material& material = scene_.materials[size_t(geometry.material)];
    const bool opaque = material.alpha == scene::Material::Alpha::Opaque && material.double_sided;
    BvhTriangle triangle{};
    triangle.primitive = index - firsts_[g];
    triangle.geometry = uint32_t(g) | (opaque ? BVH_OPAQUE : 0);
    for (size_t c = 0; c < 3; ++c)
      triangle.corner[c] = geometry.vertices[geometry.indices[3 * size_t(triangle.primitive) + c]].position;
    return triangle;
  }

 private:
  size_t geometryOf(uint32_t index) const {
    return size_t(std::upper_bound(firsts_.begin(), firsts_.end(), index) - firsts_.begin()) - 1;
  }

  const scene::Scene& scene_;
  const scene::Mesh& mesh_;
  std::vector<uint32_t> firsts_;
  uint32_t count_ = 0;
};

}  // namespace

MeshTrees buildMeshTrees(const scene::Scene& scene) {
  MeshTrees trees;
  size_t all = 0;
  for (const scene::Mesh& mesh : scene.meshes) all += Triangles(scene, mesh).count();
  trees.triangles.reserve(all);
  for (const scene::Mesh& mesh : scene.meshes) {
    const Triangles triangles(scene, mesh);
    std::vector<BvhItem> items = triangles.items();
    Bvh bvh = buildBvh(items);
    trees.bounds.push_back(bvh.bounds);
    const uint32_t first_node = uint32_t(trees.nodes.size()), first_triangle = uint32_t(trees.triangles.size());
    trees.roots.push_back(first_node);
    for (BvhNode& node : bvh.nodes)
      for (uint32_t& child : node.children) child += child & BVH_LEAF ? first_triangle : first_node;
    if (trees.nodes.empty()) trees.nodes = std::move(bvh.nodes);
    else trees.nodes.insert(trees.nodes.end(), bvh.nodes.begin(), bvh.nodes.end());
    for (const BvhItem& item : items) trees.triangles.push_back(triangles.at(item.index));
  }
  return trees;
}

BendingTree::BendingTree(const scene::Scene& scene, const scene::Mesh& mesh) {
  const Triangles triangles(scene, mesh);
  std::vector<BvhItem> items = triangles.items();
  bvh_ = buildBvh(items);
  for (const BvhItem& item : items) {
    triangles_.push_back(triangles.at(item.index));
    vertices_.push_back(triangles.verticesOf(item.index));
  }
}

void BendingTree::fit(std::span<const shared::SceneDeformedVertex> vertices, uint32_t first_node,
                      uint32_t first_triangle, BvhNode* nodes, BvhTriangle* triangles) {
  std::vector<Box> boxes(triangles_.size());
  for (size_t i = 0; i < triangles_.size(); ++i) {
    for (size_t c = 0; c < 3; ++c) triangles_[i].corner[c] = vertices[vertices_[i][c]].position;
    boxes[i] = boxOf(triangles_[i]);
    triangles[i] = triangles_[i];
  }
  refitBvh(bvh_, boxes);
  for (const BvhNode& node : bvh_.nodes) {
    *nodes = node;
    for (uint32_t& child : nodes->children) child += child & BVH_LEAF ? first_triangle : first_node;
    ++nodes;
  }
}

}  // namespace strobe::world
