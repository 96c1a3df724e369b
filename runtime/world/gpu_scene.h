// SPDX-License-Identifier: MIT
// A scene on the device: static buffers, textures and what rays traverse once, and what moves for each slice of time a
// frame asks for. The structures are those of shaders/shared/scene.h.
#pragma once

#include <string>
#include <vector>

#include "gpu/pipeline.h"
#include "scene/scene.h"
#include "scene/screen_motion.h"
#include "shared/frame.h"
#include "shared/scene.h"
#include "world/bent_instances.h"
#include "world/scene_meshes.h"
#include "world/scene_surfaces.h"
#include "world/structures.h"

namespace strobe::world {

// What no pose changes of a scene, on the device: once for all its copies that are posed apart.
struct UnposedScene {
  // The device and the scene must outlive it.
  UnposedScene(const gpu::Device& device, const scene::Scene& scene) : meshes(device, scene), surfaces(device, scene) {}
  SceneMeshes meshes;
  SceneSurfaces surfaces;
};

// Owns descriptor set 0, which every pass is bound to: the frame's uniform block and the scene's arrays.
class GpuScene {
 public:
  // `slices`: how many times the scene can be posed at once, at least SLICE_SAMPLE (the capture and its neighbours).
  // `unposed` is of the scene, which must fit (world/fits.h); the driver's structures need a device that has them.
  GpuScene(const gpu::Device& device, const scene::Scene& scene, uint32_t slices,
           const std::shared_ptr<UnposedScene>& unposed, shader::StructureKind structures);

  VkDescriptorSetLayout setLayout() const { return set_layout_.get(); }
  // What decides the layout of the set: scenes that say the same have compatible layouts.
  std::string layoutText() const;
  VkDescriptorSet set() const { return set_; }
  uint32_t slices() const { return slices_; }
  uint32_t instanceCount() const { return uint32_t(instances_.size()); }
  uint32_t lightCount() const { return uint32_t(light_nodes_.size()); }
  VkBuffer indexBuffer() const { return unposed_->meshes.indices().handle(); }

  struct Draw {
    uint32_t first_index, index_count;
    int32_t first_vertex;
    uint32_t instance;
  };
  // In the order of instances, then geometries; `gl_InstanceIndex` of draw i is i.
  const std::vector<Draw>& draws() const { return draws_; }

  // What follows is written through `staging`, whose copies must be recorded before work that reads it: later writes of
  // other frames leave alone what work before them reads.
  // The frame's block.
  void setFrame(gpu::Staging& staging, const shared::FrameData& frame) const;
  // Which instances may move within the frame's exposure, as rays may ask for these alone, and how they go over the
  // picture. Before the poses of the frame; empty: each may, in any way.
  void setMotion(gpu::Staging& staging, const std::vector<bool>& moves, const std::vector<scene::ScreenPath>& paths);
  uint32_t movingCount() const;
  bool mayMove(uint32_t instance) const { return moves_[instance]; }
  // Poses slice `slice`; positions become relative to `origin`. `aspect` is width / height, `moving` the pixels in
  // which something that moves may be seen then. Throws `Error` for a pose that cannot be drawn; what is written by
  // then must be copied all the same.
  void setPose(gpu::Staging& staging, uint32_t slice, const scene::Pose& pose, double aspect, const dvec3& origin,
               const ivec4& moving);
  // Records what makes `count` posed slices, at least one, ready to be traced: the capture, or samples.
  void recordBuild(VkCommandBuffer commands, uint32_t first_slice, uint32_t count) const;

 private:
  void uploadGeometry(const scene::Scene& scene);
  void makeSet();
  [[noreturn]] void refuseTransform(int node) const;
  double depthRange(uint32_t slice, const scene::Pose& pose) const;

  const gpu::Device& device_;
  const scene::Scene& scene_;
  uint32_t slices_;
  std::vector<scene::Instance> instances_;
  std::vector<bool> moves_;  // by instance
  std::vector<int> light_nodes_;
  std::vector<Draw> draws_;
  std::vector<shared::SceneInstance> instance_data_;
  std::shared_ptr<UnposedScene> unposed_;
  BentInstances bent_;
  std::vector<int> bent_items_;  // by instance: its number among those that bend, else -1
  gpu::Buffer frame_, addresses_, geometry_buffer_, instance_buffer_, draw_buffer_, lights_, transforms_, cameras_;
  std::unique_ptr<Structures> structures_;
  gpu::Owned<VkDescriptorSetLayout> set_layout_;
  gpu::Owned<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};

}  // namespace strobe::world
