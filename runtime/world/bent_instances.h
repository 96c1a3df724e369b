// SPDX-License-Identifier: MIT
// Instances that bend: their vertices on the device, as they are at each slice.
#pragma once

#include <vector>

#include "gpu/staging.h"
#include "math/bounds.h"
#include "scene/scene.h"
#include "shared/scene.h"
#include "world/scene_meshes.h"

namespace strobe::world {

class BentInstances {
 public:
  // The device and the scene must outlive it. `meshes` are the scene's.
  BentInstances(const gpu::Device& device, const scene::Scene& scene, const SceneMeshes& meshes, uint32_t slices);

  const std::vector<SceneMeshes::Bending>& items() const { return items_; }
  // Of all items, at one slice.
  uint32_t vertexCount() const { return vertex_count_; }
  // Of the first vertex of an item at a slice, whose vertices follow each other; of all at the first slice.
  VkDeviceAddress address(uint32_t slice, size_t item) const;
  VkDeviceAddress address() const { return buffer_.address(); }

  // Bends all items, unless the slice has them thus. Positions are relative to `origin` where joints have them.
  void pose(gpu::Staging& staging, uint32_t slice, const scene::Pose& pose, const dvec3& origin);
  // World from item, as its vertices are at the slice.
  const dmat4& world(uint32_t slice, size_t item) const { return at(slice, item).world; }
  // As they are at a slice that is posed, until the next call; and around them. Not finite where a joint is nowhere.
  const std::vector<shared::SceneDeformedVertex>& vertices(uint32_t slice, size_t item);
  const Bounds& bounds(uint32_t slice, size_t item) const { return at(slice, item).bounds; }
  // Another number whenever they change.
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
  std::vector<std::vector<shared::SceneDeformedVertex>> bent_;  // by item, those that were asked for last
  std::vector<uint32_t> bent_at_;                               // and at which slice
  gpu::Buffer buffer_;
};

}  // namespace strobe::world
