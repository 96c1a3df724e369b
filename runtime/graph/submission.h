// SPDX-License-Identifier: MIT
// How steps reach the device, and how long they take there.
#pragma once

#include "gpu/commands.h"
#include "gpu/staging.h"
#include "graph/recording.h"

namespace strobe::graph {

// What it refers to must outlive it.
class Submission {
 public:
  // `frames`: how many are under way at once.
  Submission(const gpu::Device& device, const world::GpuScene& scene, const Recording& recording, PlanNodes& nodes,
             size_t frames);

  // What of a frame goes to the device at once.
  struct Part {
    std::vector<const plan::Step*> steps = {};
    int iteration = 0;
    uint32_t first_slice = 0, slice_count = 0;  // of which structures are built before
  };
  // Step by step, each waited for: one frame on a software device.
  bool isStepwise() const { return device_.info().software && frames_.size() == 1; }
  // Begins one of the frames, which is not under way.
  void begin(size_t frame) { frames_[frame].gpu_ms = 0; }
  // Through which the host writes for the part of the frame that is submitted next.
  gpu::Staging& staging(size_t frame) { return frames_[frame].staging; }
  // Submits a part of a frame, behind all that was submitted before.
  void submit(size_t frame, const Part& part);
  // Waits for all parts of a frame that were submitted. Counts and times go to the nodes.
  void wait(size_t frame);
  // Spans of the parts of a frame, summed.
  double gpuMs(size_t frame) const { return frames_[frame].gpu_ms; }

 private:
  // A part that was submitted.
  struct Submitted {
    gpu::Commands commands;
    PassStamps stamps;
    std::string names;  // of its passes
    double allowance_s = 0;
  };
  struct Frame {
    gpu::Staging staging;
    std::vector<Submitted> parts;  // made when they are first needed
    size_t pending = 0;            // of them, the first ones
    double gpu_ms = 0;
  };
  void runStepwise(size_t frame, const Part& part);
  void submitStamped(Frame& frame, const Part& part);
  void recordScene(VkCommandBuffer commands, Frame& frame, const Part& part) const;
  double compileBeforeUse(const plan::Step& step);
  std::string nameOf(const plan::Step& step) const;

  const gpu::Device& device_;
  const world::GpuScene& scene_;
  const Recording& recording_;
  PlanNodes& nodes_;
  std::vector<Frame> frames_;
};

}  // namespace strobe::graph
