// SPDX-License-Identifier: MIT
// Submits steps to the device and measures their times.
#pragma once

#include "gpu/commands.h"
#include "gpu/staging.h"
#include "graph/recording.h"

namespace strobe::graph {

// Submits frames in parts; the constructor's arguments must outlive it.
class Submission {
 public:
  // `frames`: maximum number of frames in flight.
  Submission(const gpu::Device& device, const world::GpuScene& scene, const CommandRecording& recording,
             PlanNodes& nodes, size_t frames);

  // Steps of a frame that are submitted together.
  struct Part {
    std::vector<const plan::Step*> steps = {};
    int iteration = 0;
    uint32_t first_slice = 0, slice_count = 0;  // slices to build acceleration structures for, before the steps
  };
  // True if each step is submitted alone and timed with the host clock: one frame in flight on a device without usable
  // time stamps.
  bool isStepwise() const { return !device_.measuresTimes() && frames_.size() == 1; }
  // Begins frame `frame`, which must not be in flight.
  void begin(size_t frame) { frames_[frame].gpu_ms = 0; }
  // Host writes for the next part that is submitted.
  gpu::Staging& staging(size_t frame) { return frames_[frame].staging; }
  // Submits a part of a frame after all earlier submissions.
  void submit(size_t frame, const Part& part);
  // Waits for all submitted parts of a frame and stores counts and times in the nodes.
  void wait(size_t frame);
  // GPU time of the submitted parts of a frame, ms.
  double gpuMs(size_t frame) const { return frames_[frame].gpu_ms; }

 private:
  // A submitted part.
  struct Submitted {
    gpu::Commands commands;
    PassStamps stamps;
    std::string names;  // of its passes, for messages
    double allowance_s = 0;
    double start_s = 0;
  };
  struct Frame {
    gpu::Staging staging;
    std::vector<Submitted> parts;  // created on first use
    size_t pending = 0;            // parts not waited for, from the first
    double gpu_ms = 0;
  };
  void submitPart(Frame& frame, const Part& part);
  void recordScene(VkCommandBuffer commands, Frame& frame, const Part& part) const;
  double compileBeforeUse(const plan::Step& step);
  std::string nameOf(const plan::Step& step) const;

  const gpu::Device& device_;
  const world::GpuScene& scene_;
  const CommandRecording& recording_;
  PlanNodes& nodes_;
  std::vector<Frame> frames_;
};

}  // namespace strobe::graph
