// SPDX-License-Identifier: MIT
// Images that are zero when the pass that writes them begins, cleared by compute shaders: what a device has for clears
// may go through units for drawing, of which it may have few (docs/benchmarks.md, "On a GPU").
#pragma once

#include <map>

#include "graph/images.h"
#include "graph/pipelines.h"

namespace strobe::graph {

class Clears {
 public:
  explicit Clears(const gpu::Device& device) : device_(device) {}
  // For the images that nodes of the plan clear; buffers are none. Pipelines are those of the cache, which must outlive
  // it. Throws `Error`.
  void make(PipelineCache& cache, const plan::Plan& plan, const PlanImages& images);
  bool has(int image) const { return cleared_.count(image) > 0; }
  // A dispatch over an image that it has.
  void record(VkCommandBuffer commands, int image) const;

 private:
  struct Cleared {
    const gpu::Pipeline* pipeline = nullptr;
    gpu::Owned<VkDescriptorPool> pool;
    VkDescriptorSet set = VK_NULL_HANDLE;
    uint32_t width = 0, height = 0;
  };
  const gpu::Device& device_;
  std::map<int, Cleared> cleared_;  // by virtual image
};

}  // namespace strobe::graph
