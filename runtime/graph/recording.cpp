// SPDX-License-Identifier: MIT
// How a plan's steps become commands, and how those reach the device.
#include "base/log.h"
#include "graph/graph.h"

namespace strobe::graph {

using plan::PlanNode;
using plan::Step;

static VkPipelineStageFlags2 vulkanStages(uint32_t stages) {
  VkPipelineStageFlags2 flags = 0;
  if (stages & plan::kStageCompute) flags |= VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
  if (stages & plan::kStageTrace) flags |= VK_PIPELINE_STAGE_2_RAY_TRACING_SHADER_BIT_KHR;
  if (stages & plan::kStageFragment)
    flags |= VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT;
  if (stages & plan::kStageDepth)
    flags |= VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
  if (stages & plan::kStageColor) flags |= VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
  if (stages & plan::kStageTransfer) flags |= VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
  if (stages & plan::kStageHost) flags |= VK_PIPELINE_STAGE_2_HOST_BIT;
  return flags;
}

static VkAccessFlags2 vulkanAccess(uint32_t access) {
  VkAccessFlags2 flags = 0;
  if (access & plan::kAccessSampledRead) flags |= VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
  if (access & plan::kAccessStorageRead) flags |= VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
  if (access & plan::kAccessStorageWrite) flags |= VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
  if (access & plan::kAccessColorWrite) flags |= VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
  if (access & plan::kAccessDepthRead) flags |= VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
  if (access & plan::kAccessDepthWrite) flags |= VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
  if (access & plan::kAccessTransferRead) flags |= VK_ACCESS_2_TRANSFER_READ_BIT;
  if (access & plan::kAccessTransferWrite) flags |= VK_ACCESS_2_TRANSFER_WRITE_BIT;
  if (access & plan::kAccessHostRead) flags |= VK_ACCESS_2_HOST_READ_BIT;
  return flags;
}

void Graph::recordBarriers(VkCommandBuffer commands, const std::vector<plan::Barrier>& barriers) {
  std::vector<VkMemoryBarrier2> memory;
  for (const plan::Barrier& barrier : barriers) {
    VkMemoryBarrier2 dependency{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    dependency.srcStageMask = vulkanStages(barrier.src_stages);
    dependency.srcAccessMask = vulkanAccess(barrier.src_access);
    dependency.dstStageMask = vulkanStages(barrier.dst_stages);
    dependency.dstAccessMask = vulkanAccess(barrier.dst_access);
    memory.push_back(dependency);
  }
  if (memory.empty()) return;
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = uint32_t(memory.size());
  dependency.pMemoryBarriers = memory.data();
  device_.vk().CmdPipelineBarrier2(commands, &dependency);
}

void Graph::record(VkCommandBuffer commands, const Step& step, int iteration) {
  recordBarriers(commands, iteration == 0 ? step.barriers : step.barriers_next);
  switch (step.kind) {
    case Step::Kind::ClearImage:
      return recordClear(commands, step.index);
    case Step::Kind::Pass:
      return recordPass(commands, step.index);
    case Step::Kind::ReadImage:
      return recordRead(commands, step.index);
    // Counters live in host memory: the host clears them before the frame and reads them after it.
    case Step::Kind::ClearCounters:
    case Step::Kind::ReadCounters:
      return;
    case Step::Kind::Loop:
      STROBE_ASSERT(false, "loops do not nest");
  }
}

// What an earlier frame left in an image, made visible to what follows.
static void recordHistoryBarrier(const gpu::Device& device, VkCommandBuffer commands) {
  VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = 1;
  dependency.pMemoryBarriers = &barrier;
  device.vk().CmdPipelineBarrier2(commands, &dependency);
}

void Graph::recordClear(VkCommandBuffer commands, int image) {
  auto history = history_.find(image);
  if (history != history_.end() && history->second) return recordHistoryBarrier(device_, commands);
  VkClearColorValue zero{};
  VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  device_.vk().CmdClearColorImage(commands, imageOf(image).handle(), VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &range);
}

void Graph::recordRead(VkCommandBuffer commands, int image) {
  if (wanted_ && !wants(image)) return;
  const plan::VirtualImage& source = plan_->images[size_t(image)];
  VkBufferImageCopy copy{};
  copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  copy.imageExtent = {uint32_t(source.width), uint32_t(source.height), 1};
  device_.vk().CmdCopyImageToBuffer(commands, imageOf(image).handle(), VK_IMAGE_LAYOUT_GENERAL,
                                    read_back_.at(image).handle(), 1, &copy);
}

void Graph::bindNode(VkCommandBuffer commands, const Node& node) {
  const gpu::Pipeline& pipeline = node.pipeline->pipeline;
  VkDescriptorSet sets[] = {scene_.set(), node.set};
  device_.vk().CmdBindPipeline(commands, pipeline.bindPoint(), pipeline.handle());
  device_.vk().CmdBindDescriptorSets(commands, pipeline.bindPoint(), pipeline.layout(), 0, 2, sets, 0, nullptr);
}

// A compute or trace pass over this many pixels.
void Graph::recordWork(VkCommandBuffer commands, const Node& node, uint32_t width, uint32_t height) {
  if (node.pipeline->interface.backend == Backend::Pipeline)
    return node.pipeline->pipeline.recordTrace(commands, width, height);
  const uint32_t group = shader::kGroupSize;
  device_.vk().CmdDispatch(commands, (width + group - 1) / group, (height + group - 1) / group, 1);
}

void Graph::recordPass(VkCommandBuffer commands, int node_index) {
  const auto& vk = device_.vk();
  const PlanNode& planned = plan_->nodes[size_t(node_index)];
  const Node& node = nodes_[size_t(node_index)];
  if (device_.debugLabels()) {
    VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
    label.pLabelName = plan_->pipeline.nodes[size_t(planned.node)].name.c_str();
    vk.CmdBeginDebugUtilsLabelEXT(commands, &label);
  }
  bool stamped = !device_.info().software;
  int begin = stamped ? timer_.recordStamp(commands) : -1;
  bindNode(commands, node);
  if (node.pipeline->interface.raster) recordRaster(commands, planned);
  else recordWork(commands, node, uint32_t(planned.width), uint32_t(planned.height));
  int end = stamped ? timer_.recordStamp(commands) : -1;
  if (begin >= 0 && end >= 0) stamps_.push_back({node_index, begin, end});
  if (device_.debugLabels()) vk.CmdEndDebugUtilsLabelEXT(commands);
}

void Graph::recordRaster(VkCommandBuffer commands, const PlanNode& planned) {
  const auto& vk = device_.vk();
  auto attachment = [this](int image) {
    VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    info.imageView = imageOf(image).view();
    info.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
    info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    return info;
  };
  std::vector<VkRenderingAttachmentInfo> colors;
  for (int image : planned.writes) colors.push_back(attachment(image));
  VkRenderingAttachmentInfo depth = attachment(planned.depth);
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea.extent = {uint32_t(planned.width), uint32_t(planned.height)};
  info.layerCount = 1;
  info.colorAttachmentCount = uint32_t(colors.size());
  info.pColorAttachments = colors.data();
  info.pDepthAttachment = &depth;
  vk.CmdBeginRendering(commands, &info);
  VkViewport viewport{0, 0, float(planned.width), float(planned.height), 0, 1};
  vk.CmdSetViewport(commands, 0, 1, &viewport);
  vk.CmdSetScissor(commands, 0, 1, &info.renderArea);
  vk.CmdBindIndexBuffer(commands, scene_.indexBuffer(), 0, VK_INDEX_TYPE_UINT32);
  const auto& draws = scene_.draws();
  for (uint32_t i = 0; i < draws.size(); ++i)
    if (draws[i].index_count)
      vk.CmdDrawIndexed(commands, draws[i].index_count, 1, draws[i].first_index, draws[i].first_vertex, i);
  vk.CmdEndRendering(commands);
}

// Makes what shaders wrote to host memory visible to the host.
static void recordHostBarrier(const gpu::Device& device, VkCommandBuffer commands) {
  VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = 1;
  dependency.pMemoryBarriers = &barrier;
  device.vk().CmdPipelineBarrier2(commands, &dependency);
}

void Graph::submit(const std::vector<const Step*>& steps, int iteration, uint32_t first_slice, uint32_t slice_count) {
  auto record_builds = [&](VkCommandBuffer commands) {
    for (uint32_t i = 0; i < slice_count; ++i) scene_.recordBuild(commands, first_slice + i);
  };
  if (device_.info().software) submitStepwise(steps, iteration, slice_count, record_builds);
  else submitStamped(steps, iteration, record_builds);
  for (Node& node : nodes_) takeCounts(node);
}

// Of the node that a step runs, "" for other steps.
std::string Graph::nameOf(const Step& step) const {
  return step.kind == Step::Kind::Pass ? plan_->pipeline.nodes[size_t(plan_->nodes[size_t(step.index)].node)].name : "";
}

// A software device compiles a shader when it is first used, which is not counted as its running. Work on no
// pixels at all compiles it and runs nothing, so that one that never ends is known as such. Drawing has no such thing.
static constexpr double kCompileAllowance_s = 120;

double Graph::compileBeforeUse(const Step& step) {
  if (step.kind != Step::Kind::Pass) return 0;
  const Node& node = nodes_[size_t(step.index)];
  if (std::exchange(node.pipeline->ran, true)) return 0;
  if (node.pipeline->interface.raster) return kCompileAllowance_s;
  auto record_nothing = [&](VkCommandBuffer commands) {
    bindNode(commands, node);
    recordWork(commands, node, 0, 0);
  };
  device_.submit(record_nothing, nameOf(step), kCompileAllowance_s);
  return 0;
}

// A software device executes when something waits, against its time stamps: one submission per step, by the clock.
void Graph::submitStepwise(const std::vector<const Step*>& steps, int iteration, uint32_t slice_count,
                           const Record& record_builds) {
  double start_s = clockSeconds();
  if (slice_count > 0) {
    device_.submit(record_builds);
    gpu_ms_ += 1000 * (clockSeconds() - start_s);
  }
  for (const Step* step : steps) {
    double allowance_s = compileBeforeUse(*step);
    start_s = clockSeconds();
    auto record_step = [&](VkCommandBuffer commands) {
      record(commands, *step, iteration);
      recordHostBarrier(device_, commands);
    };
    device_.submit(record_step, nameOf(*step), allowance_s);
    double ms = 1000 * (clockSeconds() - start_s);
    gpu_ms_ += ms;
    if (step->kind != Step::Kind::Pass) continue;
    nodes_[size_t(step->index)].gpu_ms += ms;
    ++nodes_[size_t(step->index)].executions;
  }
}

void Graph::submitStamped(const std::vector<const Step*>& steps, int iteration, const Record& record_builds) {
  stamps_.clear();
  std::string names;
  for (const Step* step : steps)
    if (step->kind == Step::Kind::Pass) names += (names.empty() ? "" : ", ") + nameOf(*step);
  auto record_all = [&](VkCommandBuffer commands) {
    timer_.recordReset(commands);
    timer_.recordStamp(commands);
    record_builds(commands);
    for (const Step* step : steps) record(commands, *step, iteration);
    timer_.recordStamp(commands);
    recordHostBarrier(device_, commands);
  };
  device_.submit(record_all, names);
  std::vector<double> ms = timer_.readMs();
  gpu_ms_ += ms.back();
  for (const PendingStamp& stamp : stamps_) {
    nodes_[size_t(stamp.node)].gpu_ms += ms[size_t(stamp.end)] - ms[size_t(stamp.begin)];
    ++nodes_[size_t(stamp.node)].executions;
  }
}

// Moves what the device counted into 64 bits, so that a long loop does not overflow.
void Graph::takeCounts(Node& node) {
  auto* counted = static_cast<uint32_t*>(node.counters.mapped());
  for (size_t c = 0; c < node.counts.size(); ++c) node.counts[c] += std::exchange(counted[c], 0u);
}

}  // namespace strobe::graph
