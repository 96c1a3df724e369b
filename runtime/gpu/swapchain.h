// SPDX-License-Identifier: MIT
// The images that a window shows in turn.
#pragma once

#include <optional>
#include <vector>

#include "gpu/resources.h"

namespace strobe::gpu {

// Owns the surface and its swapchain; the window must outlive it. `Device::submit` waits for the work on an image, so
// neither acquiring nor presenting needs a semaphore.
class Swapchain {
 public:
  // Takes ownership of `surface`. Throws `Error` if the device cannot present to it.
  Swapchain(const Device& device, VkSurfaceKHR surface);

  // Image and view to draw to; the content is undefined.
  struct Target {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
  };
  // Empty if the window has no area or has changed its size; call `resize` then.
  std::optional<Target> acquire();
  // Presents the last acquired image, which must be in the layout PRESENT_SRC. False if the window has changed; call
  // `resize` then.
  bool present();
  // Recreates the images; `width` and `height` apply if the window leaves the size open.
  void resize(uint32_t width, uint32_t height);

  VkFormat format() const { return format_.format; }
  VkExtent2D extent() const { return extent_; }
  bool canBeRead() const { return can_be_read_; }

 private:
  void chooseFormat();
  void makeViews();

  const Device& device_;
  Owned<VkSurfaceKHR, VkInstance> surface_;
  Owned<VkSwapchainKHR> swapchain_;
  Owned<VkFence> acquired_;
  std::vector<VkImage> images_;
  std::vector<Owned<VkImageView>> views_;
  VkSurfaceFormatKHR format_{};
  VkExtent2D extent_{};
  uint32_t current_ = 0;
  bool can_be_read_ = false;
};

}  // namespace strobe::gpu
