// SPDX-License-Identifier: MIT
// Trees over the triangles of a scene's meshes, in the layout of the tracing backend `bvh`.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "shared/scene.h"
#include "world/bvh.h"

namespace strobe::world {

// Bounding volume hierarchies of all meshes of a scene, in shared arrays of nodes and triangles.
struct MeshTrees {
  std::vector<shared::BvhNode> nodes;          // of all meshes; child indices count across meshes
  std::vector<shared::BvhTriangle> triangles;  // in leaf order
  std::vector<uint32_t> roots;                 // by mesh; without triangles: a node without children
  std::vector<Box> bounds;                     // by mesh, object space; without triangles: inverted
};

MeshTrees buildMeshTrees(const scene::Scene& scene);

// Tree over a deformed mesh: topology of the undeformed mesh, bounds of the deformed vertices.
class BendingTree {
 public:
  // The scene must outlive it.
  BendingTree(const scene::Scene& scene, const scene::Mesh& mesh);
  size_t nodes() const { return bvh_.nodes.size(); }
  size_t triangles() const { return triangles_.size(); }
  // `vertices`: of all geometries of the mesh, in order. Writes the tree to `nodes` and `triangles`; child indices
  // count from `first_node` and `first_triangle`.
  void fit(std::span<const shared::SceneDeformedVertex> vertices, uint32_t first_node, uint32_t first_triangle,
           shared::BvhNode* nodes, shared::BvhTriangle* triangles);
  // Bounds of the triangles of the last fit; largest absolute coordinate of the root's planes.
  const Box& bounds() const { return bvh_.bounds; }
  float reach() const { return bvh_.nodes.front().reach; }

 private:
  Bvh bvh_;
  std::vector<shared::BvhTriangle> triangles_;     // in leaf order
  std::vector<std::array<uint32_t, 3>> vertices_;  // vertices of each triangle, across geometries
};

}  // namespace strobe::world
