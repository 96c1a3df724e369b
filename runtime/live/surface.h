// SPDX-License-Identifier: MIT
// What the panels draw, on the window: Dear ImGui's lists of triangles through the project's own Vulkan calls.
// (Its own Vulkan backend of the versions in use knows no textures but its font.)
#pragma once

#include <imgui.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/home.h"
#include "gpu/pipeline.h"
#include "gpu/swapchain.h"
#include "image/image.h"

namespace strobe::live {

// A picture on the device that panels show. The surface it came from must outlive it.
class Texture {
 public:
  int width() const { return int(image_.desc().width); }
  int height() const { return int(image_.desc().height); }
  // For ImGui::Image and the like; valid while this texture lives where it is.
  ImTextureID id() const { return (ImTextureID)(intptr_t)this; }

 private:
  friend class Surface;
  gpu::Image image_;
  gpu::Buffer staging_;
  VkSampler sampler_ = VK_NULL_HANDLE;  // the surface's
  gpu::Owned<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};

class Surface {
 public:
  // Takes over `surface`. An ImGui context with its fonts must be current. Throws `Error`.
  Surface(const Home& home, const gpu::Device& device, VkSurfaceKHR surface, int width, int height);

  // Puts a display image (sRGB-encoded, three channels) into `texture`, making it anew where size or filter is another.
  // `smooth`: scaled with a linear filter instead of as squares.
  void upload(std::unique_ptr<Texture>& texture, const std::string& name, const image::Image& display, bool smooth);

  // Draws ImGui's frame and shows it. With `shot`, that becomes what the window shows. False where nothing could be
  // shown (the window is hidden, or was resized: the next frame will be).
  bool show(const ImDrawData& frame, int width, int height, image::Image* shot = nullptr);

 private:
  void makePipeline(const Home& home);
  void makeFont();
  std::unique_ptr<Texture> makeTexture(const std::string& name, uint32_t width, uint32_t height, VkSampler sampler);
  void fill(Texture& texture, const void* rgba);
  void takeGeometry(const ImDrawData& frame);
  void record(VkCommandBuffer commands, const ImDrawData& frame, const gpu::Swapchain::Target& target,
              const gpu::Buffer* shot) const;
  void recordLists(VkCommandBuffer commands, const ImDrawData& frame) const;
  void recordCommand(VkCommandBuffer commands, const ImDrawData& frame, const ImDrawCmd& command, uint32_t first_index,
                     int32_t first_vertex) const;
  image::Image imageFrom(const gpu::Buffer& pixels) const;

  const gpu::Device& device_;
  gpu::Swapchain swapchain_;
  gpu::Owned<VkDescriptorSetLayout> set_layout_;
  gpu::Pipeline pipeline_;
  gpu::Owned<VkSampler> nearest_, linear_;
  std::unique_ptr<Texture> font_;
  gpu::Buffer vertices_, indices_;
  bool outdated_ = false;
};

}  // namespace strobe::live
