// SPDX-License-Identifier: MIT
// Buffers, images and samplers as move-only types; each has a name, which validation messages show.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gpu/device.h"
#include "gpu/memory.h"

namespace strobe::gpu {

// Owns one Vulkan object of a device (or instance) and the call that destroys it.
template <class Handle, class Parent = VkDevice>
class Owned {
 public:
  using Destroy = void(VKAPI_PTR*)(Parent, Handle, const VkAllocationCallbacks*);
  Owned() = default;
  Owned(Parent parent, Handle handle, Destroy destroy) : parent_(parent), handle_(handle), destroy_(destroy) {}
  Owned(Owned&& other) noexcept { *this = std::move(other); }
  Owned& operator=(Owned&& other) noexcept {
    std::swap(parent_, other.parent_);
    std::swap(handle_, other.handle_);
    std::swap(destroy_, other.destroy_);
    return *this;
  }
  ~Owned() {
    if (handle_) destroy_(parent_, handle_, nullptr);
  }
  Handle get() const { return handle_; }

 private:
  Parent parent_ = {};
  Handle handle_ = {};
  Destroy destroy_ = nullptr;
};

// Creates a named object from `info` with the vkCreate... function `make`. Throws `Error` "creating KIND NAME".
template <class Handle, class Info>
Owned<Handle> create(const Device& device, VkObjectType type,
                     VkResult(VKAPI_PTR* make)(VkDevice, const Info*, const VkAllocationCallbacks*, Handle*),
                     typename Owned<Handle>::Destroy destroy, const Info& info, const char* kind,
                     const std::string& name) {
  Handle handle = VK_NULL_HANDLE;
  check(make(device.handle(), &info, nullptr, &handle), fmt::format("creating {} {}", kind, name));
  device.setName(type, uint64_t(handle), name);
  return {device.handle(), handle, destroy};
}

// Pipeline stages and memory accesses on one side of a barrier.
struct Touch {
  VkPipelineStageFlags2 stages;
  VkAccessFlags2 access;
};
void recordBarrier(const Device& device, VkCommandBuffer commands, const Touch& before, const Touch& after);

// Layout change of all levels of an image.
struct LayoutChange {
  VkImage image;
  VkImageLayout from, to;
  VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};
void recordBarrier(const Device& device, VkCommandBuffer commands, const Touch& before, const Touch& after,
                   const LayoutChange& change);

// Usage of a buffer that shaders read by its address.
inline constexpr VkBufferUsageFlags kReadByAddress =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;

// A storage buffer. Host memory is coherent and always mapped; device memory is written by copies
// (gpu/staging.h).
class Buffer {
 public:
  enum class Memory { Host, Device };
  Buffer() = default;
  // `size` in bytes. Allocates at least 4, so that an empty array can be bound.
  Buffer(const Device& device, const std::string& name, size_t size, VkBufferUsageFlags usage, Memory memory);

  VkBuffer handle() const { return buffer_.get(); }
  size_t size() const { return size_; }
  VkDeviceAddress address() const { return address_; }
  void* mapped() const { return mapped_; }

 private:
  MemoryRange memory_;
  Owned<VkBuffer> buffer_;
  size_t size_ = 0;
  VkDeviceAddress address_ = 0;
  void* mapped_ = nullptr;
};

// Format, size in pixels, number of mip levels and usage of a 2-D image.
struct ImageDesc {
  VkFormat format = VK_FORMAT_UNDEFINED;
  uint32_t width = 1, height = 1, levels = 1;
  VkImageUsageFlags usage = 0;
  bool operator==(const ImageDesc&) const = default;
};

// A 2-D image in device memory, always in the GENERAL layout after the first transition.
class DeviceImage {
 public:
  DeviceImage() = default;
  DeviceImage(const Device& device, const std::string& name, const ImageDesc& desc);
  VkImage handle() const { return image_.get(); }
  VkImageView view() const { return view_.get(); }
  const ImageDesc& desc() const { return desc_; }

 private:
  ImageDesc desc_;
  MemoryRange memory_;
  Owned<VkImage> image_;
  Owned<VkImageView> view_;
};

// Descriptor of an image in the GENERAL layout.
inline VkDescriptorImageInfo inGeneral(VkImageView view, VkSampler sampler = VK_NULL_HANDLE) {
  return {sampler, view, VK_IMAGE_LAYOUT_GENERAL};
}

// Transition from UNDEFINED to GENERAL, for a new image.
void recordFirstLayout(const Device& device, VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect);

// Filters, mip mode and wrap modes of a texture sampler; by default nearest filters and clamping to the edge.
struct SamplerDesc {
  VkFilter magnify = VK_FILTER_NEAREST, minify = VK_FILTER_NEAREST;
  VkSamplerMipmapMode between = VK_SAMPLER_MIPMAP_MODE_NEAREST;
  bool first_level_only = false;
  VkSamplerAddressMode wrap_u = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  VkSamplerAddressMode wrap_v = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  auto operator<=>(const SamplerDesc&) const = default;
};
inline constexpr SamplerDesc kLinear = {VK_FILTER_LINEAR, VK_FILTER_LINEAR, VK_SAMPLER_MIPMAP_MODE_LINEAR};
Owned<VkSampler> makeSampler(const Device& device, const std::string& name, const SamplerDesc& desc);

}  // namespace strobe::gpu
