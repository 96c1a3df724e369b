// SPDX-License-Identifier: MIT
// What the nodes of a plan hold on a device: pipelines, parameters, counters and the set that binds them to images.
#pragma once

#include "graph/images.h"
#include "graph/pipelines.h"

namespace strobe::graph {

// A part of the buffer that all nodes share.
struct BufferPart {
  size_t offset = 0, bytes = 0;
};

// What a node has in one of the frames that are under way at once.
struct NodeInFrame {
  VkDescriptorSet set = VK_NULL_HANDLE;
  BufferPart params, counters;
  uint32_t* counted = nullptr;  // by the device, in `counters`
  std::vector<uint64_t> counts;
  double gpu_ms = 0;
  int executions = 0;

  void begin();
  // Moves what the device counted into 64 bits, so that a long loop does not overflow.
  void takeCounts();
};

struct Node {
  std::shared_ptr<const NodePipeline> pipeline;
  gpu::Owned<VkDescriptorPool> pool;
  std::vector<NodeInFrame> frames;
};

// The nodes of one plan, in its order. The plan and the device must outlive it.
class PlanNodes {
 public:
  PlanNodes(const gpu::Device& device, const plan::Plan& plan);

  // A shader that does not compile keeps the pipeline of the node of that name in `previous` (may be null), if that
  // serves the same interface; what was wrong is then added to `problems` (null: thrown). Throws `Error` with all that
  // nothing serves.
  void findPipelines(PipelineCache& cache, const world::GpuScene& scene, Backend backend, const PlanNodes* previous,
                     std::vector<std::string>* problems);
  // Makes buffers and sets for the images and for each of the frames that are under way at once.
  void make(const PlanImages& images, size_t frames);
  // Goes on with a plan of the same shape.
  void setPlan(const plan::Plan& plan);
  // Readies the nodes for one of these frames, which is not under way.
  void begin(size_t frame);

  size_t size() const { return nodes_.size(); }
  Node& operator[](size_t i) { return nodes_[i]; }
  const Node& operator[](size_t i) const { return nodes_[i]; }
  std::vector<Node>::iterator begin() { return nodes_.begin(); }
  std::vector<Node>::iterator end() { return nodes_.end(); }
  const plan::PlanNode& planned(size_t i) const { return plan_->nodes[i]; }
  const std::string& name(size_t i) const { return plan_->pipeline.nodes[size_t(planned(i).node)].name; }
  const plan::PassDesc& pass(size_t i) const { return plan_->pipeline.passes[size_t(planned(i).pass)]; }

 private:
  void layOut(size_t frames);
  void writeParams(size_t i, size_t frame);
  void fillSet(size_t i, size_t frame, const PlanImages& images);
  const Node* named(const std::string& name) const;

  const gpu::Device& device_;
  const plan::Plan* plan_;
  std::vector<Node> nodes_;
  gpu::Buffer numbers_;  // parameters and counters of all nodes in all frames: drivers take long over each allocation
  std::vector<bool> has_params_;  // by frame: those of the plan
  gpu::Owned<VkSampler> nearest_, linear_;
};

}  // namespace strobe::graph
