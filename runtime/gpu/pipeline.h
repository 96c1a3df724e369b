// SPDX-License-Identifier: MIT
// Pipelines from SPIR-V, and their descriptor layouts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gpu/resources.h"

namespace strobe::gpu {

using Spirv = std::vector<uint32_t>;

Owned<VkDescriptorSetLayout> makeSetLayout(const Device& device, const std::string& name,
                                           const std::vector<VkDescriptorSetLayoutBinding>& bindings);

// A descriptor set with a pool of its own.
class DescriptorSet {
 public:
  DescriptorSet() = default;
  // `layout` was made from `bindings`.
  DescriptorSet(const Device& device, const std::string& name, VkDescriptorSetLayout layout,
                const std::vector<VkDescriptorSetLayoutBinding>& bindings);
  VkDescriptorSet handle() const { return set_; }
  // Writes all descriptors of binding `number`. No command in execution may use the set.
  void write(uint32_t number, const VkDescriptorBufferInfo& buffer) const;
  void write(uint32_t number, const Buffer& buffer) const { write(number, {buffer.handle(), 0, VK_WHOLE_SIZE}); }
  void write(uint32_t number, const std::vector<VkDescriptorImageInfo>& images) const;
  void write(uint32_t number, const std::vector<VkAccelerationStructureKHR>& structures) const;

 private:
  void update(uint32_t number, VkWriteDescriptorSet write) const;
  const Device* device_ = nullptr;
  std::vector<VkDescriptorSetLayoutBinding> bindings_;
  Owned<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};

// SPIR-V of a graphics pipeline, with its color formats, blending, push constants and vertex layout.
struct RasterShaders {
  Spirv vertex, fragment;
  std::vector<VkFormat> color_formats;
  bool overlay = false;         // alpha-blended over the target, without depth
  uint32_t constant_bytes = 0;  // push constants of the vertex shader
  uint32_t vertex_stride = 0;   // bytes per vertex of a vertex buffer; 0: the shader fetches its vertices
  std::vector<VkVertexInputAttributeDescription> attributes = {};
};

// SPIR-V of the four stages of a ray tracing pipeline: ray generation, miss, closest hit and any hit.
struct TraceShaders {
  Spirv raygen, miss, closest_hit, any_hit;
};

// A pipeline with its layout; a ray tracing pipeline also has its shader binding table.
class Pipeline {
 public:
  Pipeline() = default;
  VkPipeline handle() const { return pipeline_.get(); }
  VkPipelineLayout layout() const { return layout_.get(); }
  VkPipelineBindPoint bindPoint() const { return bind_point_; }

  static Pipeline compute(const Device& device, const std::string& name, const Spirv& code,
                          const std::vector<VkDescriptorSetLayout>& sets);
  // Triangles without culling, with dynamic viewport and scissor; depth test GREATER on reversed D32, except for an
  // overlay.
  static Pipeline raster(const Device& device, const std::string& name, const RasterShaders& shaders,
                         const std::vector<VkDescriptorSetLayout>& sets);
  // One ray generation, one miss and one hit group.
  static Pipeline trace(const Device& device, const std::string& name, const TraceShaders& shaders,
                        const std::vector<VkDescriptorSetLayout>& sets);

  void recordTrace(VkCommandBuffer commands, uint32_t width, uint32_t height) const;

 private:
  static Pipeline withLayout(const Device& device, const std::string& name,
                             const std::vector<VkDescriptorSetLayout>& sets, VkPipelineBindPoint bind_point,
                             uint32_t constant_bytes = 0);
  void own(VkResult result, VkPipeline pipeline, const std::string& name);
  void makeBindingTable(const Device& device, const std::string& name);

  const Device* device_ = nullptr;
  Owned<VkPipelineLayout> layout_;
  Owned<VkPipeline> pipeline_;
  VkPipelineBindPoint bind_point_ = VK_PIPELINE_BIND_POINT_COMPUTE;
  Buffer binding_table_;
  VkStridedDeviceAddressRegionKHR raygen_{}, miss_{}, hit_{}, callable_{};
};

// Clock ticks since the first of `stamps`, for a counter of `bits` bits that begins again at 0 after its last value.
// The time between two stamps must be shorter than the period of the counter.
std::vector<uint64_t> ticksSinceFirst(const std::vector<uint64_t>& stamps, uint32_t bits);

// GPU time stamps of the steps of a frame; none on a device without time stamps.
class Timer {
 public:
  Timer() = default;
  Timer(const Device& device, uint32_t capacity);
  void recordReset(VkCommandBuffer commands);
  // Returns the index of the stamp; -1 if the capacity is exhausted or the device has no time stamps.
  int recordStamp(VkCommandBuffer commands);
  // Milliseconds since the first stamp, one per stamp recorded since the reset.
  std::vector<double> readMs() const;

 private:
  const Device* device_ = nullptr;
  Owned<VkQueryPool> pool_;
  uint32_t capacity_ = 0, used_ = 0;
};

}  // namespace strobe::gpu
