// SPDX-License-Identifier: MIT
// Runs a plan on a device: makes its images, records its commands, reads back what it keeps.
#pragma once

#include <functional>
#include <map>
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
  double capture_s = 0;           // scene time of the capture
  double open_s = 0, close_s = 0;  // the exposure window
  double frame_s = 0;             // time from frame to frame
  uint32_t anchor = 0;            // ANCHOR_* of shaders/shared/frame.h
  uint32_t frame = 0;
  uint32_t seed = 0;
  vec2 subpixel = vec2(0);        // sample position relative to the pixel's centre, px
  scene::Environment environment;
  scene::PixelArea reach;         // where anything that moves can be seen
};

// What was read back of one image: floats, or unsigned integers.
struct ReadImage {
  std::string format;
  image::Image floats;
  image::UintImage uints;
};

struct StepTime {
  std::string name;  // node
  double gpu_ms = 0;  // summed over the iterations of its loop
  int executions = 0;
};

struct FrameResult {
  std::map<std::string, ReadImage> outputs;                     // by name of the output
  std::map<std::string, ReadImage> taps;                        // by "node.port"
  std::vector<std::pair<std::string, uint64_t>> counters;       // "node.counter", in the order of execution
  std::vector<std::pair<std::string, int>> iterations;          // of each loop, fewer than planned if it stopped early
  std::vector<StepTime> times;
  double gpu_ms = 0;   // spans of the submissions, summed
};

// Owns the device memory of one plan. The plan, the scene and the device must outlive it.
class Graph {
 public:
  // Throws `Error` for shaders that do not compile or do not match their declarations.
  Graph(const gpu::Device& device, PipelineCache& cache, const plan::Plan& plan, scene::GpuScene& scene, Backend backend);

  // Draws one frame and waits for it. `on_iteration` (may be empty) is called after each iteration of a loop.
  FrameResult run(const FrameSetup& setup, const std::function<void(int done, int of)>& on_iteration = {});

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

  void makeImages();
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
  void recordRaster(VkCommandBuffer commands, const plan::PlanNode& planned);
  void recordClear(VkCommandBuffer commands, int image);
  void recordRead(VkCommandBuffer commands, int image);
  void runLoop(const FrameSetup& setup, const plan::Step& step, shared::FrameData frame, FrameResult& result,
               const std::function<void(int, int)>& on_iteration);
  const gpu::Image& imageOf(int virtual_image) const;
  ReadImage fetch(int image) const;
  void collect(FrameResult& result) const;

  const gpu::Device& device_;
  const plan::Plan& plan_;
  scene::GpuScene& scene_;
  Backend backend_;
  bool traces_ = false;
  std::vector<gpu::Image> slots_;
  gpu::Image unwired_;  // stands behind optional reads nothing is wired to
  gpu::Image unwired_uint_;
  gpu::Owned<VkSampler> nearest_, linear_;
  std::vector<Node> nodes_;
  std::map<int, gpu::Buffer> read_back_;  // by virtual image
  gpu::Timer timer_;
  std::vector<PendingStamp> stamps_;
  double gpu_ms_ = 0;
};

}  // namespace strobe::graph
