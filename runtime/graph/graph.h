// SPDX-License-Identifier: MIT
// Runs a plan on a device: makes its images, records its commands, reads back what it keeps.
#pragma once

#include <deque>
#include <optional>

#include "graph/submission.h"

namespace strobe::graph {

// Owns the device memory of one plan. The plan, the scene and the device must outlive it.
class Graph {
 public:
  // Time samples of all loops that are done, and how many there are: one total over the frame. A loop that stops early
  // counts as done.
  using OnIteration = std::function<void(int done, int of)>;

  // `in_flight`: how many frames may be under way at once. Throws `Error` for shaders that do not compile or do not
  // match their declarations. With `previous`, takes its place and takes over the images and histories that are
  // described alike, while none of its frames is under way; a shader that does not compile keeps the pipeline of the
  // node of that name, if that serves the same interface; what was wrong is added to `problems` (null: thrown). Throws
  // where nothing serves or memory runs out, and `previous` is as it was.
  Graph(const gpu::Device& device, PipelineCache& cache, const plan::Plan& plan, world::GpuScene& scene,
        Backend backend, size_t in_flight, Graph* previous = nullptr, std::vector<std::string>* problems = nullptr);
  // Waits for the frames that are under way.
  ~Graph();

  // Draws one frame and waits for it; drops those that are under way. `on_iteration` (may be empty) is called after
  // each iteration of a loop.
  FrameResult run(const FrameSetup& setup, const OnIteration& on_iteration = {});

  // Frames that the device still works on while the host readies the next ones and looks at those before. They are
  // executed in the order in which they begin, and each gives what it would by itself. A frame whose loops are
  // long, or end by what they find, is alone: the host waits for each of their iterations.
  size_t mostUnderWay() const { return in_flight_; }
  size_t underWay() const { return under_way_.size(); }
  // Begins a frame, while fewer than the most are under way.
  void begin(const FrameSetup& setup, const OnIteration& on_iteration = {});
  // Waits for the frame that began first of those under way.
  FrameResult finish();
  // Waits for all of them and forgets them.
  void drop();

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

  // Bytes that a graph of the plan takes for its images, before it is made.
  static ImageBytes bytes(const plan::Plan& plan, size_t in_flight);
  // The sample slices per iteration the plan's loops need, 0 without loops.
  static uint32_t sampleSlices(const plan::Plan& plan);

 private:
  // A frame from its beginning to its end.
  struct UnderWay {
    size_t index = 0;  // of its buffers and commands
    std::optional<std::set<std::string>> wanted = {};
    FrameResult result = {};
    int samples_done = 0, samples = 0;  // of all loops

    bool wants(const std::string& name) const { return !wanted || wanted->count(name); }
  };
  UnderWay takeFirst();
  void draw(const FrameSetup& setup, UnderWay& frame, const OnIteration& on_iteration);
  shared::FrameData posed(const FrameSetup& setup, const UnderWay& frame);
  void runLoop(const FrameSetup& setup, const plan::Step& step, shared::FrameData data, UnderWay& frame,
               const OnIteration& on_iteration);
  void collect(UnderWay& frame) const;

  const plan::Plan* plan_;
  world::GpuScene& scene_;
  bool waits_ = false;  // for each iteration of loops
  size_t in_flight_ = 1;
  std::deque<UnderWay> under_way_;  // in the order in which they began
  size_t next_ = 0;                 // index of the frame that begins next
  bool traces_ = false;
  double compile_ms_ = 0;
  uint64_t runs_ = 0;
  PlanNodes nodes_;
  Clears clears_;
  Recording recording_;
  Submission submission_;
  PlanImages images_;  // last: taken over from a graph before only when all else is there
};

}  // namespace strobe::graph
