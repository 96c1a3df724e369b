// SPDX-License-Identifier: MIT
// The images of a window that are shown one after the other.
#pragma once

#include <optional>
#include <vector>

#include "gpu/resources.h"

namespace strobe::gpu {

// Owns the surface and its swapchain; the window must outlive it. Work on an image is submitted with `Device::submit`,
// which waits for it, so that neither acquiring nor presenting needs a semaphore.
class Swapchain {
 public:
  // Takes over `surface`. Throws `Error` where the device cannot show pictures on it.
  Swapchain(const Device& device, VkSurfaceKHR surface);

  // Image and view to draw on; its content is undefined.
  struct Target {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
  };
  // Nothing where the window has no area, or changed its size: `resize` then.
  std::optional<Target> acquire();
  // The image last acquired must be in the layout PRESENT_SRC. False where the window changed: `resize` then.
  bool present();
  // Makes the images anew; `width` and `height` count where the window leaves the size open.
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
