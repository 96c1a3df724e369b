// SPDX-License-Identifier: MIT
// Records the steps of a plan as Vulkan commands.
#pragma once

#include "graph/clears.h"
#include "graph/nodes.h"

namespace strobe::graph {

// Time stamps of passes; indices are -1 without time stamps.
struct PassStamps {
  struct Pending {
    size_t node;
    int begin, end;
  };
  gpu::Timer timer;
  std::vector<Pending> pending;
};

// Records commands; the constructor's arguments must outlive it.
class CommandRecording {
 public:
  CommandRecording(const gpu::Device& device, const world::GpuScene& scene, PlanImages& images, const PlanNodes& nodes,
                   const Clears& clears)
      : device_(device), scene_(scene), images_(images), nodes_(nodes), clears_(clears) {}

  // Selects the plan and the frame in flight to record.
  void setFrame(const plan::Plan& plan, size_t frame, const Frame& setup) {
    plan_ = &plan, frame_ = frame;
    wanted_ = setup.wanted, moving_rect_ = setup.motion.moving_rect, camera_rests_ = !setup.facts.camera_moves;
    const scene::PixelArea& moving_rect = moving_rect_;
    reaches_all_ =
        moving_rect.x0 <= 0 && moving_rect.y0 <= 0 && moving_rect.x1 >= plan.width && moving_rect.y1 >= plan.height;
  }

  // Records any step except a loop, and adds the stamps of a pass to `stamps`.
  void step(VkCommandBuffer commands, const plan::Step& step, int iteration, PassStamps& stamps) const;
  // Records a compute or trace pass over zero pixels.
  void emptyPass(VkCommandBuffer commands, const GraphNode& node) const;
  // Makes the writes of earlier frames available to the commands that follow.
  void frameBarrier(VkCommandBuffer commands) const;
  // Makes the writes of shaders to host memory visible to the host.
  void hostBarrier(VkCommandBuffer commands) const;

 private:
  void barriers(VkCommandBuffer commands, const std::vector<plan::Barrier>& barriers) const;
  void pass(VkCommandBuffer commands, size_t node_index, int iteration, PassStamps& stamps) const;
  void bind(VkCommandBuffer commands, const GraphNode& node) const;
  void work(VkCommandBuffer commands, const GraphNode& node, uint32_t width, uint32_t height) const;
  bool isOfMoving(const plan::PlanNode& planned) const { return planned.moving_only && camera_rests_; }
  void workInMovingRect(VkCommandBuffer commands, const GraphNode& node, const plan::PlanNode& planned) const;
  VkRect2D drawnArea(const plan::PlanNode& planned, int iteration) const;
  void raster(VkCommandBuffer commands, const GraphNode& node, const plan::PlanNode& planned, int iteration) const;
  void clear(VkCommandBuffer commands, int image) const;
  void copyOutside(VkCommandBuffer commands, int image) const;
  void read(VkCommandBuffer commands, int image) const;
  bool wants(const std::string& name) const { return !wanted_ || wanted_->count(name); }
  bool isRead(int image) const;
  bool isBuffer(int image) const;

  const gpu::Device& device_;
  const world::GpuScene& scene_;
  PlanImages& images_;
  const PlanNodes& nodes_;
  const Clears& clears_;
  const plan::Plan* plan_ = nullptr;
  size_t frame_ = 0;
  const std::set<std::string>* wanted_ = nullptr;
  scene::PixelArea moving_rect_;
  bool reaches_all_ = false;
  bool camera_rests_ = false;
};

}  // namespace strobe::graph
