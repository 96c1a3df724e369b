// SPDX-License-Identifier: MIT
// Meshes of a scene on the device: data that no pose changes, shared by all copies of the scene that have their own
// poses.
#pragma once

#include <memory>
#include <vector>

#include "gpu/acceleration.h"
#include "gpu/staging.h"
#include "math/bounds.h"
#include "scene/scene.h"
#include "shared/scene.h"
#include "world/mesh_trees.h"

namespace strobe::world {

// Vertex, tangent and index buffers of a scene's meshes, with their acceleration structures, which are built on first
// use.
class SceneMeshes {
 public:
  // The device and the scene must outlive it. The data is on the device when `uploads` has finished.
  SceneMeshes(const gpu::Device& device, const scene::Scene& scene, gpu::Uploads& uploads);

  const gpu::Buffer& vertices() const { return vertices_; }
  // Packed tangents (world/tangent.h) of the geometries that have tangents.
  const gpu::Buffer& tangents() const { return tangents_; }
  const gpu::Buffer& indices() const { return indices_; }
  // A deformed instance. Its vertices and geometries follow the vertices and geometries of all meshes, in the order of
  // instances: undeformed, with the indices of its mesh.
  struct Bending {
    uint32_t instance = 0;
    uint32_t first_geometry = 0;
    uint32_t first_vertex = 0, vertex_count = 0;  // of all its geometries
  };
  const std::vector<Bending>& bending() const { return bending_; }
  // First vertex of the deformed instances.
  uint32_t firstBendingVertex() const { return first_bending_vertex_; }
  // Geometries of all meshes, then of the deformed instances; and the first geometry of each mesh.
  const std::vector<shared::SceneGeometry>& geometries() const { return geometries_; }
  const std::vector<uint32_t>& firstGeometry() const { return first_geometry_; }
  // Bounds of each mesh, object space.
  const std::vector<Bounds>& bounds() const { return bounds_; }
  // Build inputs of the driver's structures, by mesh.
  std::vector<gpu::MeshGeometry> triangles() const;
  // The driver's structures by mesh, empty for a mesh without triangles; built on the first call.
  const std::vector<gpu::Acceleration>& bottomLevels();

  // The runtime's own trees and the buffer of their triangles, built on the first call of `trees`.
  const MeshTrees& trees();
  const gpu::Buffer& treeTriangles() const { return tree_triangles_; }

 private:
  void numberGeometries();
  void numberBending();
  void upload(gpu::Uploads& uploads);

  const gpu::Device& device_;
  const scene::Scene& scene_;
  std::vector<shared::SceneGeometry> geometries_;
  std::vector<uint32_t> first_geometry_;
  std::vector<Bounds> bounds_;
  std::vector<Bending> bending_;
  uint32_t first_bending_vertex_ = 0;
  size_t vertex_count_ = 0, tangent_count_ = 0, index_count_ = 0;
  gpu::Buffer vertices_, tangents_, indices_, tree_triangles_;
  std::unique_ptr<MeshTrees> trees_;
  std::vector<gpu::Acceleration> bottom_levels_;
};

}  // namespace strobe::world
