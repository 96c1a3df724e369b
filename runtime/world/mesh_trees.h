// SPDX-License-Identifier: MIT
// The trees over the triangles of a scene's meshes, as the tracing backend `bvh` has them on the device.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "shared/scene.h"
#include "world/bvh.h"

namespace strobe::world {

struct MeshTrees {
  std::vector<shared::BvhNode> nodes;          // of all meshes; children are numbered across them
  std::vector<shared::BvhTriangle> triangles;  // in the order of leaves
  std::vector<uint32_t> roots;                 // of each mesh; of one without triangles a node without children
  std::vector<Box> bounds;                     // of each mesh, object space; of one without triangles inside out
};

MeshTrees buildMeshTrees(const scene::Scene& scene);

// The tree over a mesh that bends. Which triangles are together is that of the unbent mesh; where they are, of bent
// vertices.
class BendingTree {
 public:
  // The scene must outlive it.
  BendingTree(const scene::Scene& scene, const scene::Mesh& mesh);
  size_t nodes() const { return bvh_.nodes.size(); }
  size_t triangles() const { return triangles_.size(); }
  // `vertices`: of all geometries of the mesh, one after the other. Nodes and triangles go to these places, where they
  // are numbered from `first_node` and `first_triangle`.
  void fit(std::span<const shared::SceneDeformedVertex> vertices, uint32_t first_node, uint32_t first_triangle,
           shared::BvhNode* nodes, shared::BvhTriangle* triangles);
  // Around the vertices of the last fit, and the farthest that a plane is.
  const Box& bounds() const { return bounds_; }
  float reach() const { return bvh_.nodes.front().reach; }

 private:
  Bvh bvh_;
  std::vector<shared::BvhTriangle> triangles_;     // in the order of leaves
  std::vector<std::array<uint32_t, 3>> vertices_;  // of each, across geometries
  std::vector<Box> boxes_;                         // of triangles in the order of the mesh
  Box bounds_;
};

}  // namespace strobe::world
