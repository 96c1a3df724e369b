// SPDX-License-Identifier: MIT
#include "graph/recording.h"

#include "plan/formats.h"

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
  // Some clears are compute dispatches.
  if (stages & plan::kStageTransfer)
    flags |= VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
  if (stages & plan::kStageHost) flags |= VK_PIPELINE_STAGE_2_HOST_BIT;
  if (stages & plan::kStageIndirect) flags |= VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT;
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
  if (access & plan::kAccessTransferWrite)
    flags |= VK_ACCESS_2_TRANSFER_WRITE_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
  if (access & plan::kAccessHostRead) flags |= VK_ACCESS_2_HOST_READ_BIT;
  if (access & plan::kAccessIndirectRead) flags |= VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT;
  return flags;
}

static uint32_t widthOf(const scene::PixelArea& area) { return area.empty() ? 0 : uint32_t(area.x1 - area.x0); }
static uint32_t heightOf(const scene::PixelArea& area) { return area.empty() ? 0 : uint32_t(area.y1 - area.y0); }

void CommandRecording::barriers(VkCommandBuffer commands, const std::vector<plan::Barrier>& barriers) const {
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

void CommandRecording::step(VkCommandBuffer commands, const Step& step, int iteration, PassStamps& stamps) const {
  barriers(commands, iteration == 0 ? step.barriers : step.barriers_next);
  switch (step.kind) {
    case Step::Kind::ClearImage:
      return clear(commands, step.index);
    case Step::Kind::CopyOutside:
      return copyOutside(commands, step.index);
    case Step::Kind::Pass:
      return pass(commands, size_t(step.index), iteration, stamps);
    case Step::Kind::ReadImage:
      return read(commands, step.index);
    // Counters are in host memory: the host clears them before the frame and reads them after it.
    case Step::Kind::ClearCounters:
    case Step::Kind::ReadCounters:
      return;
    case Step::Kind::Loop:
      STROBE_ASSERT(false, "loops do not nest");
  }
}

void CommandRecording::frameBarrier(VkCommandBuffer commands) const {
  gpu::recordBarrier(
      device_, commands, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT},
      {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT});
}

void CommandRecording::clear(VkCommandBuffer commands, int image) const {
  if (images_.holdsEarlierFrame(image)) return frameBarrier(commands);
  if (isBuffer(image)) {
    device_.vk().CmdFillBuffer(commands, images_.buffer(image).handle(), 0, VK_WHOLE_SIZE, 0);
    return;
  }
  if (clears_.has(image)) return clears_.record(commands, image);
  VkClearColorValue zero{};
  VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  device_.vk().CmdClearColorImage(commands, images_.of(image).handle(), VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &range);
}

void CommandRecording::copyOutside(VkCommandBuffer commands, int image) const {
  if (reaches_all_) return;
  const plan::VirtualImage& target = plan_->images[size_t(image)];
  VkImageCopy all{};
  all.srcSubresource = all.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  all.extent = {uint32_t(target.width), uint32_t(target.height), 1};
  device_.vk().CmdCopyImage(commands, images_.of(target.outside).handle(), VK_IMAGE_LAYOUT_GENERAL,
                            images_.of(image).handle(), VK_IMAGE_LAYOUT_GENERAL, 1, &all);
}

void CommandRecording::read(VkCommandBuffer commands, int image) const {
  if (wanted_ && !isRead(image)) return;
  if (isBuffer(image)) {
    const gpu::Buffer& target = images_.readBack(image, frame_);
    VkBufferCopy entries{plan::kBufferHead, 0, target.size()};
    device_.vk().CmdCopyBuffer(commands, images_.buffer(image).handle(), target.handle(), 1, &entries);
    return;
  }
  const plan::VirtualImage& source = plan_->images[size_t(image)];
  VkBufferImageCopy copy{};
  copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  copy.imageExtent = {uint32_t(source.width), uint32_t(source.height), 1};
  device_.vk().CmdCopyImageToBuffer(commands, images_.of(image).handle(), VK_IMAGE_LAYOUT_GENERAL,
                                    images_.readBack(image, frame_).handle(), 1, &copy);
}

void CommandRecording::bind(VkCommandBuffer commands, const GraphNode& node) const {
  const gpu::Pipeline& pipeline = node.pipeline->driver->pipeline;
  VkDescriptorSet sets[] = {scene_.set(), node.frames[frame_].set.handle()};
  device_.vk().CmdBindPipeline(commands, pipeline.bindPoint(), pipeline.handle());
  device_.vk().CmdBindDescriptorSets(commands, pipeline.bindPoint(), pipeline.layout(), 0, 2, sets, 0, nullptr);
}

// Dispatches or traces `width` x `height` pixels.
void CommandRecording::work(VkCommandBuffer commands, const GraphNode& node, uint32_t width, uint32_t height) const {
  if (hasStages(node.pipeline->interface)) return node.pipeline->driver->pipeline.recordTrace(commands, width, height);
  const uint32_t group = node.pipeline->interface.group ? 1 : shader::kGroupSize;
  device_.vk().CmdDispatch(commands, (width + group - 1) / group, (height + group - 1) / group, 1);
}

// Dispatches over the texels that cover the moving rectangle; the shader adds the first texel (shader/interface.cpp).
void CommandRecording::workInMovingRect(VkCommandBuffer commands, const GraphNode& node,
                                        const PlanNode& planned) const {
  auto texels = [](int from_px, int to_px, int texels, int pixels) {
    if (texels == pixels) return uint32_t(to_px - from_px);
    return uint32_t((to_px * texels + pixels - 1) / pixels - from_px * (texels - 1) / pixels);
  };
  if (moving_rect_.empty()) return;
  work(commands, node, texels(moving_rect_.x0, moving_rect_.x1, planned.width, plan_->width),
       texels(moving_rect_.y0, moving_rect_.y1, planned.height, plan_->height));
}

void CommandRecording::pass(VkCommandBuffer commands, size_t node_index, int iteration, PassStamps& stamps) const {
  const auto& vk = device_.vk();
  const PlanNode& planned = nodes_.planned(node_index);
  const GraphNode& node = nodes_[node_index];
  if (device_.debugLabels()) {
    VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
    label.pLabelName = nodes_.name(node_index).c_str();
    vk.CmdBeginDebugUtilsLabelEXT(commands, &label);
  }
  const int begin = stamps.timer.recordStamp(commands);
  bind(commands, node);
  const bool in_stages = hasStages(node.pipeline->interface);
  const bool is_repeated = planned.static_once && plan_->loops[size_t(planned.loop)].first + iteration > 0;
  if (node.pipeline->interface.raster) raster(commands, node, planned, iteration);
  else if (planned.over >= 0 && !in_stages) vk.CmdDispatchIndirect(commands, images_.buffer(planned.over).handle(), 0);
  else if (planned.in_moving_rect || is_repeated) workInMovingRect(commands, node, planned);
  else work(commands, node, uint32_t(planned.width), uint32_t(planned.height));
  stamps.pending.push_back({node_index, begin, stamps.timer.recordStamp(commands)});
  if (device_.debugLabels()) vk.CmdEndDebugUtilsLabelEXT(commands);
}

// With a static camera, moving instances stay within the moving rectangle. In a loop, the first iteration has cleared
// the other pixels.
VkRect2D CommandRecording::drawnArea(const PlanNode& planned, int iteration) const {
  const bool of_reach = isOfMoving(planned) && planned.divide == 1 && iteration > 0;
  if (!of_reach) return {{0, 0}, {uint32_t(planned.width), uint32_t(planned.height)}};
  return {{moving_rect_.x0, moving_rect_.y0}, {widthOf(moving_rect_), heightOf(moving_rect_)}};
}

void CommandRecording::raster(VkCommandBuffer commands, const GraphNode& node, const PlanNode& planned,
                              int iteration) const {
  const auto& vk = device_.vk();
  const VkRect2D area = drawnArea(planned, iteration);
  if (area.extent.width == 0 || area.extent.height == 0) return;
  auto attachment = [this](int image) {
    VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    info.imageView = images_.of(image).view();
    info.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
    info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    return info;
  };
  std::vector<VkRenderingAttachmentInfo> colors;
  for (int image : planned.writes) colors.push_back(attachment(image));
  VkRenderingAttachmentInfo depth = attachment(planned.depth);
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea = area;
  info.layerCount = 1;
  info.colorAttachmentCount = uint32_t(colors.size());
  info.pColorAttachments = colors.data();
  info.pDepthAttachment = &depth;
  vk.CmdBeginRendering(commands, &info);
  VkViewport viewport{0, 0, float(planned.width), float(planned.height), 0, 1};
  vk.CmdSetViewport(commands, 0, 1, &viewport);
  vk.CmdSetScissor(commands, 0, 1, &info.renderArea);
  const bool indexed = !node.pipeline->interface.separate_triangles;
  if (indexed) vk.CmdBindIndexBuffer(commands, scene_.indexBuffer(), 0, VK_INDEX_TYPE_UINT32);
  const bool moving_only = isOfMoving(planned);
  const auto& draws = scene_.draws();
  for (uint32_t i = 0; i < draws.size(); ++i) {
    const auto& draw = draws[i];
    if (draw.index_count == 0 || (moving_only && !scene_.mayMove(draw.instance))) continue;
    if (indexed) vk.CmdDrawIndexed(commands, draw.index_count, 1, draw.first_index, draw.first_vertex, i);
    else vk.CmdDraw(commands, draw.index_count, 1, draw.first_index, i);
  }
  vk.CmdEndRendering(commands);
}

void CommandRecording::hostBarrier(VkCommandBuffer commands) const {
  gpu::recordBarrier(device_, commands, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT},
                     {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT});
}

void CommandRecording::emptyPass(VkCommandBuffer commands, const GraphNode& node) const {
  bind(commands, node);
  work(commands, node, 0, 0);
}

bool CommandRecording::isBuffer(int image) const { return plan::isBuffer(plan_->images[size_t(image)].format); }

bool CommandRecording::isRead(int image) const {
  for (const auto& loop : plan_->loops)
    if (loop.until == image) return true;
  for (const auto* named : {&plan_->outputs, &plan_->taps})
    for (const auto& [name, kept] : *named)
      if (kept == image && wants(name)) return true;
  return false;
}

}  // namespace strobe::graph
