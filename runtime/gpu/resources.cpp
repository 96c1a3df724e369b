// SPDX-License-Identifier: MIT
#include "gpu/resources.h"

#include <algorithm>
#include <map>

namespace strobe::gpu {

static Owned<VkDeviceMemory> allocate(const Device& device, const VkMemoryRequirements& needs,
                                      VkMemoryPropertyFlags wanted, VkMemoryPropertyFlags preferred, bool address) {
  VkMemoryAllocateFlagsInfo flags{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO};
  flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.pNext = address ? &flags : nullptr;
  info.allocationSize = needs.size;
  info.memoryTypeIndex = device.memoryType(needs.memoryTypeBits, wanted, preferred);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  check(device.vk().AllocateMemory(device.handle(), &info, nullptr, &memory),
        fmt::format("allocating {} MiB", needs.size >> 20));
  return {device.handle(), memory, device.vk().FreeMemory};
}

void recordBarrier(const Device& device, VkCommandBuffer commands, const Touch& before, const Touch& after) {
  VkMemoryBarrier2 barrier{
      VK_STRUCTURE_TYPE_MEMORY_BARRIER_2, nullptr, before.stages, before.access, after.stages, after.access};
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = 1;
  dependency.pMemoryBarriers = &barrier;
  device.vk().CmdPipelineBarrier2(commands, &dependency);
}

void recordBarrier(const Device& device, VkCommandBuffer commands, const Touch& before, const Touch& after,
                   const LayoutChange& change) {
  VkImageMemoryBarrier2 barrier{
      VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2, nullptr, before.stages, before.access, after.stages, after.access};
  barrier.oldLayout = change.from;
  barrier.newLayout = change.to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = change.image;
  barrier.subresourceRange = {change.aspect, 0, VK_REMAINING_MIP_LEVELS, 0, 1};
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &barrier;
  device.vk().CmdPipelineBarrier2(commands, &dependency);
}

Buffer::Buffer(const Device& device, const std::string& name, size_t size, VkBufferUsageFlags usage, Memory memory)
    : size_(std::max<size_t>(size, 4)) {
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = size_;
  info.usage = usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
  buffer_ =
      create(device, VK_OBJECT_TYPE_BUFFER, device.vk().CreateBuffer, device.vk().DestroyBuffer, info, "buffer", name);
  VkMemoryRequirements needs;
  device.vk().GetBufferMemoryRequirements(device.handle(), handle(), &needs);
  bool with_address = usage & VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
  bool host = memory == Memory::Host;
  memory_ =
      allocate(device, needs, host ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT : 0,
               host ? 0 : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, with_address);
  check(device.vk().BindBufferMemory(device.handle(), handle(), memory_.get(), 0), "binding buffer " + name);
  if (host)
    check(device.vk().MapMemory(device.handle(), memory_.get(), 0, VK_WHOLE_SIZE, 0, &mapped_), "mapping " + name);
  if (!with_address) return;
  VkBufferDeviceAddressInfo address{VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO};
  address.buffer = handle();
  address_ = device.vk().GetBufferDeviceAddress(device.handle(), &address);
}

static constexpr size_t kUploadPart = size_t{16} << 20;

Upload::Upload(const Device& device, const std::string& name, size_t size, VkBufferUsageFlags usage)
    : device_(device),
      buffer_(device, name, size, usage, Buffer::Memory::Device),
      staging_(device, name + ".staging", std::min(size, kUploadPart), 0, Buffer::Memory::Host) {}

void Upload::append(const void* data, size_t size) {
  for (size_t at = 0; at < size;) {
    if (held_ == staging_.size()) flush();
    const size_t part = std::min(size - at, staging_.size() - held_);
    std::memcpy(static_cast<char*>(staging_.mapped()) + held_, static_cast<const char*>(data) + at, part);
    held_ += part, at += part;
  }
}

void Upload::flush() {
  STROBE_ASSERT(done_ + held_ <= buffer_.size(), "{} bytes into {}", done_ + held_, buffer_.size());
  if (held_ == 0) return;
  device_.submit([this](VkCommandBuffer commands) {
    VkBufferCopy copy{0, done_, held_};
    device_.vk().CmdCopyBuffer(commands, staging_.handle(), buffer_.handle(), 1, &copy);
  });
  done_ += std::exchange(held_, 0);
}

Buffer Upload::finish() {
  flush();
  return std::move(buffer_);
}

Buffer uploadBuffer(const Device& device, const std::string& name, const void* data, size_t size,
                    VkBufferUsageFlags usage) {
  Upload upload(device, name, size, usage);
  upload.append(data, size);
  return upload.finish();
}

Image::Image(const Device& device, const std::string& name, const ImageDesc& desc) : desc_(desc) {
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = desc.format;
  info.extent = {desc.width, desc.height, 1};
  info.mipLevels = desc.levels;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = desc.usage;
  const Dispatch& vk = device.vk();
  image_ = create(device, VK_OBJECT_TYPE_IMAGE, vk.CreateImage, vk.DestroyImage, info, "image", name);
  VkMemoryRequirements needs;
  vk.GetImageMemoryRequirements(device.handle(), handle(), &needs);
  memory_ = allocate(device, needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, false);
  check(vk.BindImageMemory(device.handle(), handle(), memory_.get(), 0), "binding image " + name);

  bool depth = desc.format == VK_FORMAT_D32_SFLOAT;
  VkImageViewCreateInfo view_info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view_info.image = handle();
  view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view_info.format = desc.format;
  VkImageAspectFlags aspect = depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
  view_info.subresourceRange = {aspect, 0, desc.levels, 0, 1};
  view_ = create(device, VK_OBJECT_TYPE_IMAGE_VIEW, vk.CreateImageView, vk.DestroyImageView, view_info, "view", name);
}

void recordFirstLayout(const Device& device, VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect) {
  recordBarrier(device, commands, {},
                {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT},
                {image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL, aspect});
}

Image uploadImage(const Device& device, const std::string& name, ImageDesc desc,
                  const std::vector<std::vector<uint8_t>>& levels) {
  STROBE_ASSERT(levels.size() == desc.levels, "{} levels of {}", levels.size(), desc.levels);
  size_t total = 0;
  for (const auto& level : levels) total += (level.size() + 15) & ~size_t(15);
  Buffer staging(device, name + ".staging", total, 0, Buffer::Memory::Host);
  std::vector<VkBufferImageCopy> copies;
  size_t offset = 0;
  for (uint32_t l = 0; l < desc.levels; ++l) {
    std::memcpy(static_cast<char*>(staging.mapped()) + offset, levels[l].data(), levels[l].size());
    VkBufferImageCopy copy{};
    copy.bufferOffset = offset;
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, l, 0, 1};
    copy.imageExtent = {std::max(1u, desc.width >> l), std::max(1u, desc.height >> l), 1};
    copies.push_back(copy);
    offset += (levels[l].size() + 15) & ~size_t(15);
  }
  desc.usage |= VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  Image image(device, name, desc);
  device.submit([&](VkCommandBuffer commands) {
    recordBarrier(device, commands, {}, {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                  {image.handle(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL});
    device.vk().CmdCopyBufferToImage(commands, staging.handle(), image.handle(), VK_IMAGE_LAYOUT_GENERAL,
                                     uint32_t(copies.size()), copies.data());
  });
  return image;
}

Owned<VkSampler> makeSampler(const Device& device, const std::string& name, const SamplerDesc& desc) {
  VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.magFilter = desc.magnify;
  info.minFilter = desc.minify;
  info.mipmapMode = desc.between;
  info.addressModeU = desc.wrap_u;
  info.addressModeV = desc.wrap_v;
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  // With maxLod 0, a sampler would always magnify (Vulkan, "Samplers", on filters without levels).
  info.maxLod = desc.first_level_only ? 0.25f : VK_LOD_CLAMP_NONE;
  const Dispatch& vk = device.vk();
  return create(device, VK_OBJECT_TYPE_SAMPLER, vk.CreateSampler, vk.DestroySampler, info, "sampler", name);
}

const FormatInfo& formatInfo(const std::string& name) {
  static const std::map<std::string, FormatInfo> table = {
      {"r8_unorm", {VK_FORMAT_R8_UNORM, "r8", 1, 1, false}},
      {"rgba8_unorm", {VK_FORMAT_R8G8B8A8_UNORM, "rgba8", 4, 4, false}},
      {"rg16f", {VK_FORMAT_R16G16_SFLOAT, "rg16f", 2, 4, false}},
      {"rgba16f", {VK_FORMAT_R16G16B16A16_SFLOAT, "rgba16f", 4, 8, false}},
      {"r32f", {VK_FORMAT_R32_SFLOAT, "r32f", 1, 4, false}},
      {"rg32f", {VK_FORMAT_R32G32_SFLOAT, "rg32f", 2, 8, false}},
      {"rgba32f", {VK_FORMAT_R32G32B32A32_SFLOAT, "rgba32f", 4, 16, false}},
      {"r32ui", {VK_FORMAT_R32_UINT, "r32ui", 1, 4, true}},
      {"rg32ui", {VK_FORMAT_R32G32_UINT, "rg32ui", 2, 8, true}},
      {"rgba32ui", {VK_FORMAT_R32G32B32A32_UINT, "rgba32ui", 4, 16, true}},
      {"buffer32ui", {VK_FORMAT_R32_UINT, "r32ui", 1, 4, true}},
  };
  auto found = table.find(name);
  if (found == table.end()) throw Error(fmt::format("unknown image format '{}'", name));
  return found->second;
}

}  // namespace strobe::gpu
