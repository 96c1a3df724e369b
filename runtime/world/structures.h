// SPDX-License-Identifier: MIT
// Acceleration structures for tracing: over the triangles of each mesh once; over deformed meshes and over the
// instances for every pose. Pure interface; a row of shader/backends.h selects the kind for a tracing backend.
#pragma once

#include <memory>
#include <vector>

#include "gpu/acceleration.h"
#include "gpu/pipeline.h"
#include "scene/scene.h"
#include "shader/backends.h"
#include "shared/scene.h"
#include "world/bent_instances.h"
#include "world/mesh_trees.h"
#include "world/scene_meshes.h"

namespace strobe::world {

// Interface to a scene's acceleration structures at the raster time and at each sample time: binding, posing and
// builds.
class Structures {
 public:
  virtual ~Structures() = default;
  // Binding of the structures in set 0, and the write of its descriptors.
  virtual VkDescriptorSetLayoutBinding binding(uint32_t number) const = 0;
  virtual void write(const gpu::DescriptorSet& set, uint32_t number) const = 0;
  // Poses the instances at a level: level 0 is the raster time, level 1 + i is sample i. By instance: transform from
  // object to world space, and true if the instance moves (rays may be limited to moving instances). Deformed instances
  // must be posed before.
  virtual void pose(gpu::Staging& staging, uint32_t level, const std::vector<shared::SceneTransform>& transforms,
                    const std::vector<bool>& moves) = 0;
  // Records the builds of `count` levels for later tracing, after the copies of host writes.
  virtual void recordBuild(VkCommandBuffer commands, uint32_t first_level, uint32_t count) = 0;
};

// True if all triangles of the mesh have one-sided materials. A driver then culls back faces.
bool isOneSided(const scene::Scene& scene, const scene::Mesh& mesh);

// Acceleration structures of the driver. `meshes` belongs to the scene; `meshes` and `bent` must outlive the result.
std::unique_ptr<Structures> makeDriverStructures(const gpu::Device& device, const scene::Scene& scene,
                                                 SceneMeshes& meshes, BentInstances& bent, uint32_t slices);

// The runtime's own trees (shaders/shared/bvh.h). `triangles` holds the triangles of `trees` on the device; `triangles`
// and `bent` must outlive the result. The structures are on the device when `uploads` has finished.
std::unique_ptr<Structures> makeOwnStructures(const gpu::Device& device, const scene::Scene& scene,
                                              const MeshTrees& trees, const gpu::Buffer& triangles, BentInstances& bent,
                                              uint32_t slices, gpu::Uploads& uploads);

// Level of a traced slice. Slices between the raster time and the samples are never traced.
inline bool isTraced(uint32_t slice) { return slice == SLICE_RASTER || slice >= SLICE_SAMPLE; }
inline uint32_t levelOf(uint32_t slice) { return slice < SLICE_SAMPLE ? 0 : slice - SLICE_SAMPLE + 1; }
inline uint32_t sliceOf(uint32_t level) { return level == 0 ? SLICE_RASTER : level - 1 + SLICE_SAMPLE; }

}  // namespace strobe::world
