// SPDX-License-Identifier: MIT
// How steps reach the device, and how long they take there.
#pragma once

#include "graph/recording.h"

namespace strobe::graph {

// What it refers to must outlive it.
class Submission {
 public:
  Submission(const gpu::Device& device, const world::GpuScene& scene, const Recording& recording, PlanNodes& nodes);

  void beginFrame();
  // Builds the structures of `slice_count` slices, executes the steps and waits; counts and times go to the nodes.
  void run(const std::vector<const plan::Step*>& steps, int iteration, uint32_t first_slice, uint32_t slice_count);
  // Spans of the submissions of this frame, summed.
  double gpuMs() const { return gpu_ms_; }

 private:
  using Record = std::function<void(VkCommandBuffer)>;
  void runStepwise(const std::vector<const plan::Step*>& steps, int iteration, uint32_t slice_count,
                   const Record& record_builds);
  void runStamped(const std::vector<const plan::Step*>& steps, int iteration, const Record& record_builds);
  double compileBeforeUse(const plan::Step& step);
  std::string nameOf(const plan::Step& step) const;

  const gpu::Device& device_;
  const world::GpuScene& scene_;
  const Recording& recording_;
  PlanNodes& nodes_;
  PassStamps stamps_;
  double gpu_ms_ = 0;
};

}  // namespace strobe::graph
