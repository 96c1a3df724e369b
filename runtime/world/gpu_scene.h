// SPDX-License-Identifier: MIT
// A scene on the device: static buffers, textures and acceleration structures once; transforms, lights and cameras for
// each time slice of a frame. The data layouts are in shaders/shared/scene.h.
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

// Data of a scene on the device that no pose changes, shared by all copies of the scene that have their own poses.
struct UnposedScene {
  // The device and the scene must outlive it.
  UnposedScene(const gpu::Device& device, const scene::Scene& scene)
      : UnposedScene(device, scene, gpu::Uploads(device)) {}
  SceneMeshes meshes;
  SceneSurfaces surfaces;

 private:
  UnposedScene(const gpu::Device& device, const scene::Scene& scene, gpu::Uploads&& uploads)
      : meshes(device, scene, uploads), surfaces(device, scene, uploads) {
    uploads.finish();
  }
};

// Owns descriptor set 0, which every pass is bound to: the frame's uniform block and the scene's arrays.
class GpuScene {
 public:
  // `slices`: number of simultaneous poses, at least SLICE_SAMPLE (raster time, shutter open, shutter close, previous
  // frame). `unposed` belongs to `scene`, which must fit the device (world/fits.h). Structures of the driver need a
  // device with acceleration structures.
  GpuScene(const gpu::Device& device, const scene::Scene& scene, uint32_t slices,
           const std::shared_ptr<UnposedScene>& unposed, shader::StructureKind structures);

  VkDescriptorSetLayout setLayout() const { return set_layout_.get(); }
  const std::vector<VkDescriptorSetLayoutBinding>& bindings() const { return bindings_; }
  // Text that identifies the layout of the set: equal texts, compatible layouts.
  std::string layoutText() const;
  VkDescriptorSet set() const { return set_.handle(); }
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

  // The functions below write through `staging`. Its copies must be recorded before work that reads the data. Earlier
  // work still reads the earlier data.
  // Writes the frame's uniform block.
  void setFrame(gpu::Staging& staging, const shared::FrameData& frame) const;
  // By instance: true if it may move within the exposure (rays may be limited to moving instances), and its path on the
  // screen. Call before posing the frame. Empty: all may move, on any path.
  void setMotion(gpu::Staging& staging, const std::vector<bool>& moves, const std::vector<scene::ScreenPath>& paths);
  uint32_t movingCount() const;
  bool mayMove(uint32_t instance) const { return moves_[instance]; }
  // Poses a slice; positions are relative to `origin`. `aspect` is width / height, `moving` the moving rectangle at
  // this pose, px. Throws `Error` for a pose that cannot be drawn; staged data must be copied nevertheless.
  void setPose(gpu::Staging& staging, uint32_t slice, const scene::Pose& pose, double aspect, const dvec3& origin,
               const ivec4& moving);
  // Records the builds of `count` posed slices (at least one) for tracing: the raster slice, or sample slices.
  void recordBuild(VkCommandBuffer commands, uint32_t first_slice, uint32_t count) const;

 private:
  void uploadGeometry(const scene::Scene& scene, gpu::Uploads& uploads);
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
  std::vector<int> bent_items_;  // by instance: index into bent_.items(), or -1
  gpu::Buffer frame_, addresses_, geometry_buffer_, instance_buffer_, draw_buffer_, lights_, transforms_, cameras_;
  std::unique_ptr<Structures> structures_;
  std::vector<VkDescriptorSetLayoutBinding> bindings_;
  gpu::Owned<VkDescriptorSetLayout> set_layout_;
  gpu::DescriptorSet set_;
};

}  // namespace strobe::world
