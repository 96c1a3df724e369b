// SPDX-License-Identifier: MIT
// Draws the panels on the window: Dear ImGui's triangle lists through the project's own Vulkan calls. (ImGui's Vulkan
// backend, in the versions in use, has no textures except its font.)
#pragma once

#include <imgui.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/home.h"
#include "gpu/pipeline.h"
#include "gpu/staging.h"
#include "gpu/swapchain.h"
#include "image/image.h"

namespace strobe::live {

// Image on the device for the panels. The surface that made the texture must outlive it.
class PanelTexture {
 public:
  int width() const { return int(image_.desc().width); }
  int height() const { return int(image_.desc().height); }
  // Texture id for ImGui::Image and similar calls; valid while this texture exists at its address.
  // NOLINTNEXTLINE(performance-no-int-to-ptr)
  ImTextureID id() const { return (ImTextureID)(intptr_t)this; }

 private:
  friend class Surface;
  gpu::DeviceImage image_;
  VkSampler sampler_ = VK_NULL_HANDLE;  // owned by the surface
  gpu::DescriptorSet set_;
};

// Vulkan swapchain of the window with the pipeline that draws ImGui's triangle lists. Uploads the textures of the
// panels, and can return the window's pixels for a screenshot.
class Surface {
 public:
  // Takes ownership of `surface`. Needs a current ImGui context with fonts. Throws `Error`.
  Surface(const Home& home, const gpu::Device& device, VkSurfaceKHR surface, int width, int height);

  // Uploads a display image (sRGB-encoded, three channels) into `texture`. Makes a new texture if the size or filter
  // differs. `smooth`: linear filter instead of nearest.
  void upload(std::unique_ptr<PanelTexture>& texture, const std::string& name, const image::Image& display,
              bool smooth);

  // Draws ImGui's frame and presents it. `shot` (may be null) receives the window's pixels. Returns false if nothing
  // was presented because the window is hidden or was resized; call again with the next frame.
  bool show(const ImDrawData& frame, int width, int height, image::Image* shot = nullptr);

 private:
  void makePipeline(const Home& home);
  void makeFont();
  std::unique_ptr<PanelTexture> makeTexture(const std::string& name, uint32_t width, uint32_t height,
                                            VkSampler sampler);
  void fill(PanelTexture& texture, std::vector<uint8_t> rgba);
  void takeGeometry(const ImDrawData& frame);
  void record(VkCommandBuffer commands, const ImDrawData& frame, const gpu::Swapchain::Target& target,
              const gpu::Buffer* shot) const;
  void recordLists(VkCommandBuffer commands, const ImDrawData& frame) const;
  void recordCommand(VkCommandBuffer commands, const ImDrawData& frame, const ImDrawCmd& command, uint32_t first_index,
                     int32_t first_vertex) const;
  image::Image imageFrom(const gpu::Buffer& pixels) const;

  const gpu::Device& device_;
  gpu::Staging staging_;
  gpu::Swapchain swapchain_;
  gpu::Owned<VkDescriptorSetLayout> set_layout_;
  gpu::Pipeline pipeline_;
  gpu::Owned<VkSampler> nearest_, linear_;
  std::unique_ptr<PanelTexture> font_;
  gpu::Buffer vertices_, indices_;
  bool outdated_ = false;
};

}  // namespace strobe::live
