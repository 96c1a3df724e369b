// SPDX-License-Identifier: MIT
// What rays traverse: over the triangles of each mesh once, over those that bend and the instances for every pose. Pure
// interface; a row of shader/backends.h says which kind a tracing backend needs.
#pragma once

#include <memory>
#include <vector>

#include "gpu/acceleration.h"
#include "scene/scene.h"
#include "shader/backends.h"
#include "shared/scene.h"
#include "world/bent_instances.h"
#include "world/mesh_trees.h"
#include "world/scene_meshes.h"

namespace strobe::world {

class Structures {
 public:
  virtual ~Structures() = default;
  // The binding of set 0 that names them, and what is written there.
  virtual VkDescriptorSetLayoutBinding binding(uint32_t number) const = 0;
  virtual void write(VkDescriptorSet set, uint32_t number) const = 0;
  // Poses the instances at a level: 0 is the capture, 1 + i sample i. World-from-object transforms, and whether it
  // moves (rays may ask for these alone), one of each instance; what bends is posed already.
  virtual void pose(gpu::Staging& staging, uint32_t level, const std::vector<shared::SceneTransform>& transforms,
                    const std::vector<bool>& moves) = 0;
  // Records what makes the poses of `count` levels ready to be traced by later work, behind the copies of what was
  // written.
  virtual void recordBuild(VkCommandBuffer commands, uint32_t first_level, uint32_t count) = 0;
};

// Are all its triangles of materials that are seen from one side alone? A driver then leaves out what is behind.
bool isOneSided(const scene::Scene& scene, const scene::Mesh& mesh);

// Acceleration structures of the driver. `meshes` are the scene's; they and `bent` must outlive it.
std::unique_ptr<Structures> makeDriverStructures(const gpu::Device& device, const scene::Scene& scene,
                                                 SceneMeshes& meshes, BentInstances& bent, uint32_t slices);

// The runtime's own trees (shaders/shared/bvh.h). `triangles`: those of the trees, on the device; it and `bent` must
// outlive it.
std::unique_ptr<Structures> makeOwnStructures(const gpu::Device& device, const scene::Scene& scene,
                                              const MeshTrees& trees, const gpu::Buffer& triangles, BentInstances& bent,
                                              uint32_t slices);

// Whose level a slice's pose is; slices between the capture and the samples are never traced.
inline bool isTraced(uint32_t slice) { return slice == SLICE_RASTER || slice >= SLICE_SAMPLE; }
inline uint32_t levelOf(uint32_t slice) { return slice < SLICE_SAMPLE ? 0 : slice - SLICE_SAMPLE + 1; }
inline uint32_t sliceOf(uint32_t level) { return level == 0 ? SLICE_RASTER : level - 1 + SLICE_SAMPLE; }

}  // namespace strobe::world
