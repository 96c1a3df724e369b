// SPDX-License-Identifier: MIT
#include "live/surface.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "shader/compiler.h"

namespace strobe::live {

namespace {

// Push constants of shaders/live/panel.vert.glsl.
struct WindowConstants {
  float clip_per_px[2], origin_clip[2];
};

const std::vector<VkDescriptorSetLayoutBinding> kBindings = {
    {0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr}};

gpu::Spirv compiled(const Home& home, const char* file, shader::ShaderStage stage) {
  return shader::compile(home, {"#version 460\n", home.at(Path("shaders/live") / file), ""}, stage);
}

std::vector<uint8_t> toRgba8(const image::Image& display) {
  STROBE_ASSERT(display.channels == 3, "{} channels", display.channels);
  size_t pixels = size_t(display.width) * size_t(display.height);
  std::vector<uint8_t> rgba(pixels * 4, 255);
  for (size_t i = 0; i < pixels; ++i)
    for (size_t c = 0; c < 3; ++c)
      rgba[i * 4 + c] = uint8_t(std::lround(std::clamp(display.values[i * 3 + c], 0.0f, 1.0f) * 255));
  return rgba;
}

}  // namespace

Surface::Surface(const Home& home, const gpu::Device& device, VkSurfaceKHR surface, int width, int height)
    : device_(device), staging_(device), swapchain_(device, surface) {
  swapchain_.resize(uint32_t(width), uint32_t(height));
  set_layout_ = gpu::makeSetLayout(device, "panels", kBindings);
  nearest_ = gpu::makeSampler(device, "panels.nearest", {});
  linear_ = gpu::makeSampler(device, "panels.linear", gpu::kLinear);
  makePipeline(home);
  makeFont();
}

void Surface::makePipeline(const Home& home) {
  gpu::RasterShaders shaders;
  shaders.vertex = compiled(home, "panel.vert.glsl", shader::ShaderStage::Vertex);
  shaders.fragment = compiled(home, "panel.frag.glsl", shader::ShaderStage::Fragment);
  shaders.color_formats = {swapchain_.format()};
  shaders.overlay = true;
  shaders.constant_bytes = sizeof(WindowConstants);
  shaders.vertex_stride = sizeof(ImDrawVert);
  shaders.attributes = {{0, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, pos)},
                        {1, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, uv)},
                        {2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(ImDrawVert, col)}};
  pipeline_ = gpu::Pipeline::raster(device_, "panels", shaders, {set_layout_.get()});
}

std::unique_ptr<PanelTexture> Surface::makeTexture(const std::string& name, uint32_t width, uint32_t height,
                                                   VkSampler sampler) {
  auto texture = std::make_unique<PanelTexture>();
  texture->sampler_ = sampler;
  VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  texture->image_ = gpu::DeviceImage(device_, name, {VK_FORMAT_R8G8B8A8_UNORM, width, height, 1, usage});
  texture->set_ = gpu::DescriptorSet(device_, name, set_layout_.get(), kBindings);
  texture->set_.write(0, std::vector{gpu::inGeneral(texture->image_.view(), sampler)});
  return texture;
}

void Surface::fill(PanelTexture& texture, std::vector<uint8_t> rgba) {
  staging_.write(texture.image_, {std::move(rgba)});
  device_.submit([&](VkCommandBuffer commands) { staging_.recordCopies(commands); });
  staging_.reset();
}

void Surface::upload(std::unique_ptr<PanelTexture>& texture, const std::string& name, const image::Image& display,
                     bool smooth) {
  VkSampler sampler = smooth ? linear_.get() : nearest_.get();
  bool fits = texture && texture->width() == display.width && texture->height() == display.height &&
              texture->sampler_ == sampler;
  if (!fits) texture = makeTexture(name, uint32_t(display.width), uint32_t(display.height), sampler);
  fill(*texture, toRgba8(display));
}

// Makes the texture of ImGui's font and registers it with ImGui.
void Surface::makeFont() {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  font_ = makeTexture("panels.font", uint32_t(width), uint32_t(height), linear_.get());
  fill(*font_, std::vector<uint8_t>(pixels, pixels + size_t(width) * size_t(height) * 4));
  ImGui::GetIO().Fonts->SetTexID(font_->id());
}

// Copies all lists, in order, into one vertex buffer and one index buffer. The buffers grow and never shrink.
void Surface::takeGeometry(const ImDrawData& frame) {
  size_t vertex_bytes = size_t(frame.TotalVtxCount) * sizeof(ImDrawVert);
  size_t index_bytes = size_t(frame.TotalIdxCount) * sizeof(ImDrawIdx);
  auto grow = [this](gpu::Buffer& buffer, const char* name, size_t bytes, VkBufferUsageFlags usage) {
    if (!buffer.mapped() || buffer.size() < bytes)
      buffer = gpu::Buffer(device_, name, bytes * 3 / 2, usage, gpu::Buffer::Memory::Host);
  };
  grow(vertices_, "panels.vertices", vertex_bytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  grow(indices_, "panels.indices", index_bytes, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  auto* vertex = static_cast<ImDrawVert*>(vertices_.mapped());
  auto* index = static_cast<ImDrawIdx*>(indices_.mapped());
  for (int i = 0; i < frame.CmdListsCount; ++i) {
    const ImDrawList& list = *frame.CmdLists[i];
    vertex = std::copy(list.VtxBuffer.begin(), list.VtxBuffer.end(), vertex);
    index = std::copy(list.IdxBuffer.begin(), list.IdxBuffer.end(), index);
  }
}

void Surface::recordCommand(VkCommandBuffer commands, const ImDrawData& frame, const ImDrawCmd& command,
                            uint32_t first_index, int32_t first_vertex) const {
  // Clip rectangle in window pixels, clamped to the window.
  float x0 = std::max(0.0f, command.ClipRect.x - frame.DisplayPos.x);
  float y0 = std::max(0.0f, command.ClipRect.y - frame.DisplayPos.y);
  float x1 = std::min(float(swapchain_.extent().width), command.ClipRect.z - frame.DisplayPos.x);
  float y1 = std::min(float(swapchain_.extent().height), command.ClipRect.w - frame.DisplayPos.y);
  if (x1 <= x0 || y1 <= y0) return;
  VkRect2D scissor{{int32_t(x0), int32_t(y0)}, {uint32_t(x1 - x0), uint32_t(y1 - y0)}};
  const gpu::Dispatch& vk = device_.vk();
  vk.CmdSetScissor(commands, 0, 1, &scissor);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui passes ids of textures
  const VkDescriptorSet set = ((const PanelTexture*)(intptr_t)command.GetTexID())->set_.handle();
  vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.layout(), 0, 1, &set, 0, nullptr);
  vk.CmdDrawIndexed(commands, command.ElemCount, 1, first_index + command.IdxOffset,
                    first_vertex + int32_t(command.VtxOffset), 0);
}

void Surface::recordLists(VkCommandBuffer commands, const ImDrawData& frame) const {
  const gpu::Dispatch& vk = device_.vk();
  VkExtent2D extent = swapchain_.extent();
  vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.handle());
  VkViewport viewport{0, 0, float(extent.width), float(extent.height), 0, 1};
  vk.CmdSetViewport(commands, 0, 1, &viewport);
  WindowConstants constants;
  constants.clip_per_px[0] = 2 / float(extent.width);
  constants.clip_per_px[1] = 2 / float(extent.height);
  constants.origin_clip[0] = -1 - frame.DisplayPos.x * constants.clip_per_px[0];
  constants.origin_clip[1] = -1 - frame.DisplayPos.y * constants.clip_per_px[1];
  vk.CmdPushConstants(commands, pipeline_.layout(), VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(constants), &constants);
  if (frame.TotalIdxCount == 0) return;
  VkBuffer vertices = vertices_.handle();
  VkDeviceSize start = 0;
  vk.CmdBindVertexBuffers(commands, 0, 1, &vertices, &start);
  vk.CmdBindIndexBuffer(commands, indices_.handle(), 0,
                        sizeof(ImDrawIdx) == 2 ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32);
  uint32_t first_index = 0;
  int32_t first_vertex = 0;
  for (int i = 0; i < frame.CmdListsCount; ++i) {
    const ImDrawList& list = *frame.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer)
      if (!command.UserCallback) recordCommand(commands, frame, command, first_index, first_vertex);
    first_index += uint32_t(list.IdxBuffer.Size);
    first_vertex += list.VtxBuffer.Size;
  }
}

void Surface::record(VkCommandBuffer commands, const ImDrawData& frame, const gpu::Swapchain::Target& target,
                     const gpu::Buffer* shot) const {
  const gpu::Dispatch& vk = device_.vk();
  constexpr VkPipelineStageFlags2 kOutput = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
  constexpr VkImageLayout kDrawn = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  recordBarrier(device_, commands, {kOutput, 0},
                {kOutput, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT},
                {target.image, VK_IMAGE_LAYOUT_UNDEFINED, kDrawn});

  VkRenderingAttachmentInfo color{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  color.imageView = target.view;
  color.imageLayout = kDrawn;
  color.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  color.clearValue.color = {{0, 0, 0, 1}};
  VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
  rendering.renderArea = {{0, 0}, swapchain_.extent()};
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = 1;
  rendering.pColorAttachments = &color;
  vk.CmdBeginRendering(commands, &rendering);
  recordLists(commands, frame);
  vk.CmdEndRendering(commands);

  const gpu::Touch drawn{kOutput, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
  if (!shot)
    return recordBarrier(device_, commands, drawn, {}, {target.image, kDrawn, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR});
  constexpr VkPipelineStageFlags2 kCopy = VK_PIPELINE_STAGE_2_COPY_BIT;
  constexpr VkImageLayout kCopied = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
  recordBarrier(device_, commands, drawn, {kCopy, VK_ACCESS_2_TRANSFER_READ_BIT}, {target.image, kDrawn, kCopied});
  VkBufferImageCopy copy{};
  copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  copy.imageExtent = {swapchain_.extent().width, swapchain_.extent().height, 1};
  vk.CmdCopyImageToBuffer(commands, target.image, kCopied, shot->handle(), 1, &copy);
  recordBarrier(device_, commands, {kCopy, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT});
  recordBarrier(device_, commands, {kCopy, 0}, {}, {target.image, kCopied, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR});
}

image::Image Surface::imageFrom(const gpu::Buffer& pixels) const {
  image::Image image(int(swapchain_.extent().width), int(swapchain_.extent().height), 3);
  const auto* bytes = static_cast<const uint8_t*>(pixels.mapped());
  bool blue_first = swapchain_.format() == VK_FORMAT_B8G8R8A8_UNORM;
  for (size_t i = 0; i < image.values.size() / 3; ++i)
    for (size_t c = 0; c < 3; ++c) image.values[i * 3 + c] = float(bytes[i * 4 + (blue_first ? 2 - c : c)]) / 255;
  return image;
}

bool Surface::show(const ImDrawData& frame, int width, int height, image::Image* shot) {
  VkExtent2D extent = swapchain_.extent();
  if (outdated_ || int(extent.width) != width || int(extent.height) != height) {
    swapchain_.resize(uint32_t(width), uint32_t(height));
    outdated_ = false;
  }
  auto target = swapchain_.acquire();
  outdated_ = !target;
  if (!target) return false;
  if (shot && !swapchain_.canBeRead()) throw Error("this window's pictures cannot be read back on this device");

  takeGeometry(frame);
  gpu::Buffer pixels;
  size_t bytes = size_t(swapchain_.extent().width) * swapchain_.extent().height * 4;
  if (shot) pixels = gpu::Buffer(device_, "window.shot", bytes, 0, gpu::Buffer::Memory::Host);
  device_.submit([&](VkCommandBuffer commands) { record(commands, frame, *target, shot ? &pixels : nullptr); });
  if (shot) *shot = imageFrom(pixels);
  outdated_ = !swapchain_.present();
  return true;
}

}  // namespace strobe::live
