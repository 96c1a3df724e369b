// SPDX-License-Identifier: MIT
// Runs a plan on a device: makes its images, records its commands, reads back what it keeps.
#pragma once

#include "graph/submission.h"

namespace strobe::graph {

// Owns the device memory of one plan. The plan, the scene and the device must outlive it.
class Graph {
 public:
  // Throws `Error` for shaders that do not compile or do not match their declarations. With `previous`, takes its place
  // and takes over the images and histories that are described alike; a shader that does not compile keeps the pipeline
  // of the node of that name, if that serves the same interface; what was wrong is added to `problems`. Throws where
  // nothing serves or memory runs out, and `previous` is as it was.
  Graph(const gpu::Device& device, PipelineCache& cache, const plan::Plan& plan, world::GpuScene& scene,
        Backend backend, Graph* previous = nullptr, std::vector<std::string>* problems = nullptr);

  // Draws one frame and waits for it. `on_iteration` (may be empty) is called after each iteration of a loop.
  FrameResult run(const FrameSetup& setup, const std::function<void(int done, int of)>& on_iteration = {});

  // Goes on with a plan that differs in parameters which are not compiled in, and in nothing else.
  void setParams(const plan::Plan& plan);

  // What the nodes execute, by name.
  std::map<std::string, std::shared_ptr<const NodePipeline>> pipelines() const;
  // Frames drawn since it was made.
  uint64_t runs() const { return runs_; }
  // Milliseconds it took to find and compile them.
  double compileMs() const { return compile_ms_; }
  // "node.port" of the images kept from frame to frame that were taken over, and those that begin anew.
  std::vector<std::string> histories(bool taken_over) const { return images_.histories(taken_over); }
  // The next frame begins with empty histories.
  void forgetHistories() { images_.forgetHistories(); }

  // The sample slices per iteration the plan's loops need, 0 without loops.
  static uint32_t sampleSlices(const plan::Plan& plan);

 private:
  void runLoop(const FrameSetup& setup, const plan::Step& step, shared::FrameData frame, FrameResult& result,
               const std::function<void(int, int)>& on_iteration);
  void collect(FrameResult& result) const;

  const plan::Plan* plan_;
  world::GpuScene& scene_;
  bool traces_ = false;
  double compile_ms_ = 0;
  uint64_t runs_ = 0;
  PlanNodes nodes_;
  Recording recording_;
  Submission submission_;
  PlanImages images_;  // last: taken over from a graph before only when all else is there
};

}  // namespace strobe::graph
