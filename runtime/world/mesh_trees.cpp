// SPDX-License-Identifier: MIT
#include "world/mesh_trees.h"

#include "base/error.h"

namespace strobe::world {

using shared::BvhNode;
using shared::BvhTriangle;

static std::vector<BvhTriangle> trianglesOf(const scene::Scene& scene, const scene::Mesh& mesh) {
  std::vector<BvhTriangle> triangles;
  for (size_t g = 0; g < mesh.geometries.size(); ++g) {
    const scene::Geometry& geometry = mesh.geometries[g];
    const scene::Material& material = scene.materials[size_t(geometry.material)];
    bool opaque = material.alpha == scene::Material::Alpha::Opaque && material.double_sided;
    for (size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
      BvhTriangle triangle;
      for (size_t c = 0; c < 3; ++c) triangle.corner[c] = geometry.vertices[geometry.indices[i + c]].position;
      triangle.geometry = uint32_t(g) | (opaque ? BVH_OPAQUE : 0);
      triangle.primitive = uint32_t(i / 3);
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

static Box boxOf(const BvhTriangle& triangle) {
  Box box;
  for (const vec3& corner : triangle.corner) box.add(corner);
  return box;
}

MeshTrees buildMeshTrees(const scene::Scene& scene) {
  MeshTrees trees;
  for (const scene::Mesh& mesh : scene.meshes) {
    std::vector<BvhTriangle> triangles = trianglesOf(scene, mesh);
    std::vector<Box> boxes;
    trees.bounds.emplace_back();
    for (const BvhTriangle& triangle : triangles) {
      boxes.push_back(boxOf(triangle));
      trees.bounds.back().add(boxes.back());
    }
    Bvh bvh = buildBvh(boxes);
    uint32_t first_node = uint32_t(trees.nodes.size()), first_triangle = uint32_t(trees.triangles.size());
    trees.roots.push_back(first_node);
    for (BvhNode node : bvh.nodes) {
      for (uint32_t& child : node.children) child += child & BVH_LEAF ? first_triangle : first_node;
      trees.nodes.push_back(node);
    }
    for (uint32_t index : bvh.order) trees.triangles.push_back(triangles[index]);
  }
  return trees;
}

}  // namespace strobe::world
