// SPDX-License-Identifier: MIT
// Runs a plan on a device: makes its images, records its commands, reads back what it keeps.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "graph/pipelines.h"
#include "image/image.h"
#include "scene/facts.h"
#include "scene/upload.h"

namespace strobe::graph {

// When and how a frame sees its scene; everything an image depends on besides plan and scene.
struct FrameSetup {
  std::function<scene::Pose(double time_s)> pose_at;
  scene::Camera camera;
  double capture_s = 0;            // scene time of the capture
  double open_s = 0, close_s = 0;  // the exposure window
  double frame_s = 0;              // time from frame to frame
  uint32_t anchor = 0;             // ANCHOR_* of shaders/shared/frame.h
  uint32_t frame = 0;
  uint32_t seed = 0;
  vec2 subpixel = vec2(0);  // sample position relative to the pixel's centre, px
  scene::Environment environment;
  scene::PixelArea reach;                         // where anything that moves can be seen
  const std::set<std::string>* wanted = nullptr;  // outputs and taps to read back; null: all
};

// What was read back of one image: floats, or unsigned integers.
struct ReadImage {
  std::string format;
  image::Image floats;
  image::UintImage uints;
};

struct StepTime {
  std::string name;   // node
  double gpu_ms = 0;  // summed over the iterations of its loop
  int executions = 0;
};

struct FrameResult {
  std::map<std::string, ReadImage> outputs;                // by name of the output
  std::map<std::string, ReadImage> taps;                   // by "node.port"
  std::vector<std::pair<std::string, uint64_t>> counters;  // "node.counter", in the order of execution
  std::vector<std::pair<std::string, int>> iterations;     // of each loop, fewer than planned if it stopped early
  std::vector<StepTime> times;
  double gpu_ms = 0;  // spans of the submissions, summed
};

// Owns the device memory of one plan. The plan, the scene and the device must outlive it.
class Graph {
 public:
  // Throws `Error` for shaders that do not compile or do not match their declarations.
  Graph(const gpu::Device& device, PipelineCache& cache, const plan::Plan& plan, scene::GpuScene& scene,
        Backend backend);

  // Takes the place of `previous`, from which it takes over the images and histories that are described alike. A
  // shader that does not compile keeps the pipeline of the node of that name, if that serves the same interface; what
  // was wrong is added to `problems`. Throws where nothing serves or memory runs out, and `previous` is as it was.
  Graph(const gpu::Device& device, PipelineCache& cache, const plan::Plan& plan, scene::GpuScene& scene,
        Backend backend, Graph& previous, std::vector<std::string>& problems);

  // Draws one frame and waits for it. `on_iteration` (may be empty) is called after each iteration of a loop.
  FrameResult run(const FrameSetup& setup, const std::function<void(int done, int of)>& on_iteration = {});

  // Goes on with a plan that differs in parameters which are not compiled in, and in nothing else.
  void setParams(const plan::Plan& plan);

  // What the nodes execute, by name.
  std::map<std::string, std::shared_ptr<const NodePipeline>> pipelines() const;
  // Milliseconds it took to find and compile them.
  double compileMs() const { return compile_ms_; }
  // "node.port" of the images kept from frame to frame that were taken over, and those that begin anew.
  std::vector<std::string> histories(bool taken_over) const;
  // The next frame begins with empty histories.
  void forgetHistories();

  // The sample slices per iteration the plan's loops need, 0 without loops.
  static uint32_t sampleSlices(const plan::Plan& plan);

 private:
  struct Node {
    std::shared_ptr<const NodePipeline> pipeline;
    gpu::Owned<VkDescriptorPool> pool;
    VkDescriptorSet set = VK_NULL_HANDLE;
    gpu::Buffer params, counters;
    std::vector<uint64_t> counts;  // of this frame
    double gpu_ms = 0;
    int executions = 0;
  };
  struct PendingStamp {
    int node, begin, end;
  };

  void findPipelines(Graph* previous, std::vector<std::string>* problems);
  void makeImages(Graph* previous);
  gpu::Image takeOver(const plan::VirtualImage& image, const gpu::ImageDesc& desc, Graph& previous);
  void giveBack(Graph& previous);
  void makeAll(Graph* previous);
  void makeNode(const plan::PlanNode& planned, Node& node);
  void fillSet(const plan::PlanNode& planned, Node& node);
  void writeParams(const plan::PlanNode& planned, Node& node);
  shared::FrameData frameData(const FrameSetup& setup) const;
  void poseFixedSlices(const FrameSetup& setup);
  void poseSamples(const FrameSetup& setup, const plan::PlanLoop& loop, int iteration);
  void submit(const std::vector<const plan::Step*>& steps, int iteration, uint32_t first_slice, uint32_t slice_count);
  using Record = std::function<void(VkCommandBuffer)>;
  void submitStepwise(const std::vector<const plan::Step*>& steps, int iteration, uint32_t slice_count,
                      const Record& record_builds);
  void submitStamped(const std::vector<const plan::Step*>& steps, int iteration, const Record& record_builds);
  void record(VkCommandBuffer commands, const plan::Step& step, int iteration);
  static void takeCounts(Node& node);
  void recordBarriers(VkCommandBuffer commands, const std::vector<plan::Barrier>& barriers);
  void recordPass(VkCommandBuffer commands, int node_index);
  void bindNode(VkCommandBuffer commands, const Node& node);
  void recordWork(VkCommandBuffer commands, const Node& node, uint32_t width, uint32_t height);
  double compileBeforeUse(const plan::Step& step);
  void recordRaster(VkCommandBuffer commands, const plan::PlanNode& planned);
  void recordClear(VkCommandBuffer commands, int image);
  void recordRead(VkCommandBuffer commands, int image);
  void runLoop(const FrameSetup& setup, const plan::Step& step, shared::FrameData frame, FrameResult& result,
               const std::function<void(int, int)>& on_iteration);
  const gpu::Image& imageOf(int virtual_image) const;
  ReadImage fetch(int image) const;
  void collect(FrameResult& result) const;

  std::string nameOf(const plan::Step& step) const;
  bool wants(const std::string& name) const { return !wanted_ || wanted_->count(name); }
  bool wants(int image) const;
  int nodeNamed(const std::string& name) const;

  const gpu::Device& device_;
  PipelineCache& cache_;
  const plan::Plan* plan_;
  scene::GpuScene& scene_;
  Backend backend_;
  bool traces_ = false;
  std::vector<gpu::Image> slots_;
  gpu::Image unwired_;  // stands behind optional reads nothing is wired to
  gpu::Image unwired_uint_;
  gpu::Owned<VkSampler> nearest_, linear_;
  std::vector<Node> nodes_;
  std::map<int, gpu::Buffer> read_back_;                // by virtual image
  std::map<int, bool> history_;                         // by virtual image: holds an earlier frame
  std::set<std::string> taken_over_;                    // histories of a previous graph
  std::vector<std::pair<size_t, size_t>> taken_slots_;  // this one's, and that of a previous graph it came from
  const std::set<std::string>* wanted_ = nullptr;       // of the frame being drawn
  gpu::Timer timer_;
  std::vector<PendingStamp> stamps_;
  double gpu_ms_ = 0;
  double compile_ms_ = 0;
};

}  // namespace strobe::graph
