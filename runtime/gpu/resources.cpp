// SPDX-License-Identifier: MIT
#include "gpu/resources.h"

#include <algorithm>
#include <map>

namespace strobe::gpu {

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
  memory_ = device.memory().take(needs, memory == Memory::Host, name);
  mapped_ = memory_.mapped();
  check(device.vk().BindBufferMemory(device.handle(), handle(), memory_.memory(), memory_.offset()),
        "binding buffer " + name);
  if (!(usage & VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT)) return;
  VkBufferDeviceAddressInfo address{VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO};
  address.buffer = handle();
  address_ = device.vk().GetBufferDeviceAddress(device.handle(), &address);
}

DeviceImage::DeviceImage(const Device& device, const std::string& name, const ImageDesc& desc) : desc_(desc) {
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
  memory_ = device.memory().take(needs, false, name);
  check(vk.BindImageMemory(device.handle(), handle(), memory_.memory(), memory_.offset()), "binding image " + name);

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

}  // namespace strobe::gpu
