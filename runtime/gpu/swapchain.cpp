// SPDX-License-Identifier: MIT
#include "gpu/swapchain.h"

#include <algorithm>

namespace strobe::gpu {

static Owned<VkFence> makeFence(const Device& device) {
  VkFenceCreateInfo info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  const Dispatch& vk = device.vk();
  return create(device, VK_OBJECT_TYPE_FENCE, vk.CreateFence, vk.DestroyFence, info, "the fence of", "the window");
}

Swapchain::Swapchain(const Device& device, VkSurfaceKHR surface)
    : device_(device),
      surface_(device.instance(), surface, device.vk().DestroySurfaceKHR),
      acquired_(makeFence(device)) {
  VkBool32 supported = VK_FALSE;
  const Dispatch& vk = device.vk();
  check(vk.GetPhysicalDeviceSurfaceSupportKHR(device.physical(), device.queueFamily(), surface, &supported),
        "querying the window");
  if (!supported)
    throw Error(fmt::format("device '{}' cannot show pictures in a window here; choose another device with --device",
                            device.info().name));
  chooseFormat();
}

// Values are sRGB-encoded already, so the image must not encode them again.
void Swapchain::chooseFormat() {
  auto formats = listed<VkSurfaceFormatKHR>([&](uint32_t* count, VkSurfaceFormatKHR* list) {
    check(device_.vk().GetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_.get(), count, list),
          "formats of the window");
  });
  for (VkFormat wanted : {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM}) {
    auto found =
        std::find_if(formats.begin(), formats.end(), [&](const auto& offered) { return offered.format == wanted; });
    if (found == formats.end()) continue;
    format_ = *found;
    return;
  }
  throw Error(fmt::format("device '{}' offers no 8-bit format for the window", device_.info().name));
}

void Swapchain::resize(uint32_t width, uint32_t height) {
  const Dispatch& vk = device_.vk();
  check(vk.DeviceWaitIdle(device_.handle()), "waiting for the window");
  VkSurfaceCapabilitiesKHR can;
  check(vk.GetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), surface_.get(), &can), "size of the window");
  extent_ = can.currentExtent;
  if (extent_.width == UINT32_MAX) {
    extent_.width = std::clamp(width, can.minImageExtent.width, can.maxImageExtent.width);
    extent_.height = std::clamp(height, can.minImageExtent.height, can.maxImageExtent.height);
  }
  views_.clear();
  if (extent_.width == 0 || extent_.height == 0) return;

  can_be_read_ = can.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
  info.surface = surface_.get();
  info.minImageCount = std::max(2u, can.minImageCount);
  if (can.maxImageCount != 0) info.minImageCount = std::min(info.minImageCount, can.maxImageCount);
  info.imageFormat = format_.format;
  info.imageColorSpace = format_.colorSpace;
  info.imageExtent = extent_;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  if (can_be_read_) info.imageUsage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  info.preTransform = can.currentTransform;
  bool opaque = can.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
  info.compositeAlpha = opaque ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
  info.presentMode = VK_PRESENT_MODE_FIFO_KHR;  // the one mode that every device has
  info.clipped = VK_TRUE;
  info.oldSwapchain = swapchain_.get();
  swapchain_ = create(device_, VK_OBJECT_TYPE_SWAPCHAIN_KHR, vk.CreateSwapchainKHR, vk.DestroySwapchainKHR, info, "the",
                      "swapchain");
  makeViews();
}

void Swapchain::makeViews() {
  const Dispatch& vk = device_.vk();
  images_ = listed<VkImage>([&](uint32_t* count, VkImage* list) {
    check(vk.GetSwapchainImagesKHR(device_.handle(), swapchain_.get(), count, list), "images of the window");
  });
  for (VkImage image : images_) {
    device_.setName(VK_OBJECT_TYPE_IMAGE, uint64_t(image), "window");
    VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    info.image = image;
    info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    info.format = format_.format;
    info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    views_.push_back(create(device_, VK_OBJECT_TYPE_IMAGE_VIEW, vk.CreateImageView, vk.DestroyImageView, info,
                            "a view of", "the window"));
  }
}

std::optional<Swapchain::Target> Swapchain::acquire() {
  if (views_.empty()) return {};
  const Dispatch& vk = device_.vk();
  VkFence fence = acquired_.get();
  VkResult result =
      vk.AcquireNextImageKHR(device_.handle(), swapchain_.get(), UINT64_MAX, VK_NULL_HANDLE, fence, &current_);
  if (result == VK_ERROR_OUT_OF_DATE_KHR) return {};
  if (result != VK_SUBOPTIMAL_KHR) check(result, "getting an image of the window");
  check(vk.WaitForFences(device_.handle(), 1, &fence, VK_TRUE, UINT64_MAX), "waiting for the window");
  check(vk.ResetFences(device_.handle(), 1, &fence), "resetting the fence of the window");
  return Target{images_[current_], views_[current_].get()};
}

bool Swapchain::present() {
  VkSwapchainKHR swapchain = swapchain_.get();
  VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
  info.swapchainCount = 1;
  info.pSwapchains = &swapchain;
  info.pImageIndices = &current_;
  VkResult result = device_.vk().QueuePresentKHR(device_.queue(), &info);
  if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) return false;
  check(result, "showing a frame");
  return true;
}

}  // namespace strobe::gpu
