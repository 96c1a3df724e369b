// SPDX-License-Identifier: MIT
// Compute shaders that clear images to zero before the pass that writes them. A device's own clears may use its drawing
// units, which can be few (docs/benchmarks.md, "On a GPU").
#pragma once

#include <map>

#include "graph/images.h"
#include "graph/pipelines.h"

namespace strobe::graph {

// Compute pipelines and descriptor sets that set the images of one plan to zero.
class Clears {
 public:
  explicit Clears(const gpu::Device& device) : device_(device) {}
  // Creates pipelines and sets for the images that the plan clears, not for buffers. The pipelines belong to `cache`,
  // which must outlive this object. Throws `Error`.
  void make(PipelineCache& cache, const plan::Plan& plan, const PlanImages& images);
  bool has(int image) const { return cleared_.count(image) > 0; }
  // Records a dispatch over `image`; requires `has(image)`.
  void record(VkCommandBuffer commands, int image) const;

 private:
  struct Cleared {
    const gpu::Pipeline* pipeline = nullptr;
    gpu::DescriptorSet set;
    uint32_t width = 0, height = 0;
  };
  const gpu::Device& device_;
  std::map<int, Cleared> cleared_;  // by virtual image
};

}  // namespace strobe::graph
