// SPDX-License-Identifier: MIT
// Runs a plan on a device: creates its images, records its commands, reads the results back.
#pragma once

#include <deque>
#include <optional>

#include "graph/submission.h"

namespace strobe::graph {

// Owns the device memory of one plan. The plan, the scene and the device must outlive it.
class Graph {
 public:
  // Time samples done and total, summed over all loops of the frame. A loop that stops early counts as done.
  using OnIteration = std::function<void(int done, int of)>;

  // `in_flight`: maximum number of frames in flight. Throws `Error` if a shader does not compile or does not match its
  // declaration.
  // With `previous`, the new graph takes over images and histories with equal descriptions; `previous` must have no
  // frame in flight. A node whose shader does not compile keeps the pipeline of the same node of `previous`, if the
  // interface is equal; the error is added to `problems` (null: thrown). Throws if no pipeline fits or memory runs out;
  // `previous` is then unchanged.
  Graph(const gpu::Device& device, PipelineCache& cache, const plan::Plan& plan, world::GpuScene& scene,
        Backend backend, size_t in_flight, Graph* previous = nullptr, std::vector<std::string>* problems = nullptr);
  // Waits for the frames in flight.
  ~Graph();

  // Draws one frame and waits for it; drops the frames in flight. `on_iteration` (may be empty) is called after each
  // iteration of a loop.
  FrameResult run(const Frame& setup, const OnIteration& on_iteration = {});

  // Frames in flight: the device executes frames while the host prepares the next ones and reads earlier ones. Frames
  // execute in the order of `begin`; the result of a frame does not depend on the others. A plan with a long loop, or
  // with a loop that may stop early, has one frame in flight: the host waits for each iteration.
  size_t mostUnderWay() const { return in_flight_; }
  size_t underWay() const { return under_way_.size(); }
  // Begins a frame; requires `underWay() < mostUnderWay()`.
  void begin(const Frame& setup, const OnIteration& on_iteration = {});
  // Waits for the oldest frame in flight and returns its results.
  FrameResult finish();
  // Waits for all frames in flight and discards their results.
  void drop();

  // Continues with a plan that differs only in parameters that are not compiled in.
  void setParams(const plan::Plan& plan);

  // Pipelines by node name.
  std::map<std::string, std::shared_ptr<const NodePipeline>> pipelines() const;
  // Frames drawn by this graph.
  uint64_t runs() const { return runs_; }
  // Time to find and compile the pipelines, ms.
  double compileMs() const { return compile_ms_; }
  // History images ("node.port"): taken over from the previous graph, or newly created.
  std::vector<std::string> histories(bool taken_over) const { return images_.histories(taken_over); }
  // Makes the next frame begin with empty histories.
  void forgetHistories() { images_.forgetHistories(); }

  // Bytes of the images that a graph of this plan would allocate.
  static ImageBytes bytes(const plan::Plan& plan, size_t in_flight);
  // Sample slices per iteration that the plan's loops need; 0 without loops.
  static uint32_t sampleSlices(const plan::Plan& plan);

 private:
  // A frame in flight.
  struct UnderWay {
    size_t index = 0;  // of its buffers and command buffers
    std::optional<std::set<std::string>> wanted = {};
    FrameResult result = {};
    int samples_done = 0, samples = 0;  // of all loops

    bool wants(const std::string& name) const { return !wanted || wanted->count(name); }
  };
  UnderWay takeFirst();
  void draw(const Frame& setup, UnderWay& frame, const OnIteration& on_iteration);
  shared::FrameData posed(const Frame& setup, const UnderWay& frame);
  void runLoop(const Frame& setup, const plan::Step& step, shared::FrameData data, UnderWay& frame,
               const OnIteration& on_iteration);
  void collect(UnderWay& frame) const;

  const plan::Plan* plan_;
  world::GpuScene& scene_;
  bool waits_ = false;  // host waits for each iteration of a loop
  size_t in_flight_ = 1;
  std::deque<UnderWay> under_way_;  // oldest first
  size_t next_ = 0;                 // index of the frame that begins next
  bool traces_ = false;
  double compile_ms_ = 0;
  uint64_t runs_ = 0;
  PlanNodes nodes_;
  Clears clears_;
  CommandRecording recording_;
  Submission submission_;
  PlanImages images_;  // last: takes images from the previous graph only after all other members exist
};

}  // namespace strobe::graph
