// SPDX-License-Identifier: MIT
// Device objects of a plan's nodes: pipelines, parameters, counters and descriptor sets.
#pragma once

#include "graph/images.h"
#include "graph/pipelines.h"

namespace strobe::graph {

// A range of the buffer that all nodes share.
struct BufferPart {
  size_t offset = 0, bytes = 0;
};

// Data of a node for one of the frames in flight.
struct NodeInFrame {
  gpu::DescriptorSet set;
  BufferPart params, counters;
  uint32_t* counted = nullptr;  // counters that the device increments, in `counters`
  std::vector<uint64_t> counts;
  double gpu_ms = 0;
  int executions = 0;

  void begin();
  // Adds the device's 32-bit counts to the 64-bit counts, so that long loops do not overflow.
  void takeCounts();
};

// A pass instance of a frame graph on the device: its pipeline, and its data for each frame in flight.
struct GraphNode {
  std::shared_ptr<const NodePipeline> pipeline;
  std::vector<NodeInFrame> frames;
};

// Nodes of one plan, in the plan's order. The plan and the device must outlive it.
class PlanNodes {
 public:
  PlanNodes(const gpu::Device& device, const plan::Plan& plan);

  // A node whose shader does not compile keeps the pipeline of the same node of `previous` (may be null), if the
  // interface is equal; the error is added to `problems` (null: thrown). Throws `Error` with all errors of nodes
  // without a pipeline.
  void findPipelines(PipelineCache& cache, const world::GpuScene& scene, Backend backend, const PlanNodes* previous,
                     std::vector<std::string>* problems);
  // Creates buffers and descriptor sets for the images and for each frame in flight.
  void make(const PlanImages& images, size_t frames);
  // Continues with a plan of the same shape.
  void setPlan(const plan::Plan& plan);
  // Prepares the nodes for frame `frame`, which must not be in flight.
  void begin(size_t frame);

  size_t size() const { return nodes_.size(); }
  GraphNode& operator[](size_t i) { return nodes_[i]; }
  const GraphNode& operator[](size_t i) const { return nodes_[i]; }
  std::vector<GraphNode>::iterator begin() { return nodes_.begin(); }
  std::vector<GraphNode>::iterator end() { return nodes_.end(); }
  const plan::PlanNode& planned(size_t i) const { return plan_->nodes[i]; }
  const std::string& name(size_t i) const { return plan_->pipeline.nodes[size_t(planned(i).node)].name; }
  const plan::PassDesc& pass(size_t i) const { return plan_->pipeline.passes[size_t(planned(i).pass)]; }

 private:
  void layOut(size_t frames);
  void writeParams(size_t i, size_t frame);
  void fillSet(size_t i, size_t frame, const PlanImages& images);
  const GraphNode* named(const std::string& name) const;

  const gpu::Device& device_;
  const plan::Plan* plan_;
  std::vector<GraphNode> nodes_;
  // Parameters and counters of all nodes and frames.
  gpu::Buffer numbers_;
  std::vector<bool> has_params_;  // by frame: holds the plan's parameters
  gpu::Owned<VkSampler> nearest_, linear_;
};

}  // namespace strobe::graph
