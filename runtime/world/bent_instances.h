// SPDX-License-Identifier: MIT
// Vertices of deformed instances on the device, at each slice.
#pragma once

#include <vector>

#include "gpu/staging.h"
#include "math/bounds.h"
#include "scene/scene.h"
#include "shared/scene.h"
#include "world/scene_meshes.h"

namespace strobe::world {

// Vertex buffer of the skinned or otherwise deformed instances of a scene, with one copy per time slice of a frame.
class BentInstances {
 public:
  // `meshes` belongs to the scene. The device and the scene must outlive it.
  BentInstances(const gpu::Device& device, const scene::Scene& scene, const SceneMeshes& meshes, uint32_t slices);

  const std::vector<SceneMeshes::Bending>& items() const { return items_; }
  // Number of vertices of all items at one slice.
  uint32_t vertexCount() const { return vertex_count_; }
  // Address of the vertices of an item at a slice; without arguments, of all vertices from the first slice on.
  VkDeviceAddress address(uint32_t slice, size_t item) const;
  VkDeviceAddress address() const { return buffer_.address(); }

  // Deforms all items at a slice, except items with unchanged deformation. Positions of items with joints are relative
  // to `origin`.
  void pose(gpu::Staging& staging, uint32_t slice, const scene::Pose& pose, const dvec3& origin);
  // Transform from an item's vertices to world space at a slice.
  const dmat4& world(uint32_t slice, size_t item) const { return at(slice, item).world; }
  // Vertices of an item at a posed slice, valid until the next call, and their bounds. The bounds are infinite if a
  // position is not finite.
  const std::vector<shared::SceneDeformedVertex>& vertices(uint32_t slice, size_t item);
  const Bounds& bounds(uint32_t slice, size_t item) const { return at(slice, item).bounds; }
  // Changes with the vertices.
  uint64_t version(uint32_t slice, size_t item) const { return at(slice, item).version; }

 private:
  struct Posed {
    scene::Bend bend;
    dvec3 shift = dvec3(0);
    dmat4 world = dmat4(1);
    Bounds bounds;
    uint64_t version = 0;
  };
  const Posed& at(uint32_t slice, size_t item) const { return posed_[slice * items_.size() + item]; }
  void bend(size_t item, Posed& posed);
  size_t firstVertex(uint32_t slice, size_t item) const;

  const scene::Scene& scene_;
  std::vector<scene::Instance> instances_;
  std::vector<SceneMeshes::Bending> items_;
  uint32_t first_vertex_ = 0, vertex_count_ = 0;
  std::vector<Posed> posed_;                                    // by slice, then item
  std::vector<std::vector<shared::SceneDeformedVertex>> bent_;  // by item: the vertices computed last
  std::vector<uint32_t> bent_at_;                               // by item: slice of these vertices
  gpu::Buffer buffer_;
};

}  // namespace strobe::world
