// SPDX-License-Identifier: MIT
// Blocks of device memory: sharing by buffers and images, and errors when memory runs out.
#include "gpu/memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "gpu/limits.h"
#include "gpu/staging.h"

namespace strobe::gpu {
namespace memory_test {

Dispatch& callsOf(Device& device) { return const_cast<Dispatch&>(device.vk()); }

// Calls of the driver, counted or refused.
PFN_vkAllocateMemory allocate = nullptr;
PFN_vkGetPhysicalDeviceProperties2 properties = nullptr;
size_t allocations = 0;
VkDeviceSize most_bytes = UINT64_MAX;  // of one allocation; larger ones are refused

VkResult counted(VkDevice device, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks* callbacks,
                 VkDeviceMemory* memory) {
  if (info->allocationSize > most_bytes) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
  ++allocations;
  return allocate(device, info, callbacks, memory);
}

class BlockTest : public ::testing::Test {
 protected:
  BlockTest() {
    allocate = std::exchange(callsOf(device_).AllocateMemory, counted);
    properties = callsOf(device_).GetPhysicalDeviceProperties2;
    allocations = 0, most_bytes = UINT64_MAX;
  }
  void TearDown() override { EXPECT_EQ(device_.takeMessages(), std::vector<std::string>()); }

  Buffer buffer(size_t bytes, Buffer::Memory memory = Buffer::Memory::Host) {
    return Buffer(device_, "numbers", bytes, kReadByAddress, memory);
  }
  std::string refusalOf(size_t bytes) {
    try {
      buffer(bytes, Buffer::Memory::Device);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  Device device_{{.validation = true}};
};

// Each of many buffers keeps its bytes while other buffers are created and destroyed.
TEST_F(BlockTest, ManyBuffersShareFewAllocations) {
  std::mt19937 random(1);
  std::map<uint32_t, Buffer> held;
  auto add = [&](uint32_t number) {
    Buffer& added = held[number] = buffer(1 + random() % 3000);
    std::memset(added.mapped(), int(number % 251), added.size());
  };
  for (uint32_t i = 0; i < 3000; ++i) add(i);
  const size_t allocated = allocations;
  EXPECT_LE(allocated, 3u);
  for (uint32_t round = 0; round < 3; ++round) {
    for (uint32_t i = 0; i < 1500; ++i) held.erase(std::next(held.begin(), random() % held.size()));
    for (uint32_t i = 0; i < 1400; ++i) add(3000 * (round + 1) + i);
  }
  EXPECT_LE(allocations, allocated + 1) << "returned ranges are used again";
  for (const auto& [number, one] : held) {
    const auto* bytes = static_cast<const uint8_t*>(one.mapped());
    EXPECT_TRUE(std::all_of(bytes, bytes + one.size(), [n = number](uint8_t byte) { return byte == n % 251; }))
        << number;
    EXPECT_EQ(one.address() % 4, 0u);
  }
}

TEST_F(BlockTest, RangesAreAlignedAndBlocksReturnedWhenUnused) {
  DeviceMemory& memory = device_.memory();
  const size_t before = memory.allocations();
  {
    std::vector<MemoryRange> ranges;
    const VkMemoryRequirements small{100, 16, ~0u}, coarse{100, 1 << 16, ~0u}, large{5 << 20, 256, ~0u};
    VkPhysicalDeviceProperties2 about{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    properties(device_.physical(), &about);
    const VkDeviceSize page = std::max<VkDeviceSize>(about.properties.limits.bufferImageGranularity, 16);
    for (int i = 0; i < 50; ++i) ranges.push_back(memory.take(i % 3 ? small : coarse, false, "range"));
    EXPECT_EQ(memory.allocations(), before + 1);
    for (size_t i = 0; i < ranges.size(); ++i) {
      EXPECT_EQ(ranges[i].offset() % (i % 3 ? page : 1 << 16), 0u) << i;
      for (size_t k = 0; k < i; ++k)
        EXPECT_TRUE(ranges[k].offset() + 100 <= ranges[i].offset() || ranges[i].offset() + 100 <= ranges[k].offset());
    }
    ranges.push_back(memory.take(large, false, "large"));
    EXPECT_EQ(memory.allocations(), before + 2) << "a large resource has its own allocation";
    EXPECT_EQ(ranges.back().offset(), 0u);
    ranges.pop_back();
    EXPECT_EQ(memory.allocations(), before + 1);
    ranges.push_back(memory.take(small, true, "mapped"));
    EXPECT_EQ(memory.allocations(), before + 2) << "host memory has its own block";
    EXPECT_NE(ranges.back().mapped(), nullptr);
    EXPECT_EQ(ranges.front().mapped(), nullptr);
  }
  EXPECT_EQ(memory.allocations(), before);
}

// A device that requires buffers and images to be 64 KiB apart.
TEST_F(BlockTest, RangesKeepTheGranularityOfTheDevice) {
  callsOf(device_).GetPhysicalDeviceProperties2 = [](VkPhysicalDevice device, VkPhysicalDeviceProperties2* result) {
    properties(device, result);
    result->properties.limits.bufferImageGranularity = 1 << 16;
  };
  DeviceMemory memory(device_);
  const VkMemoryRequirements needs{100, 16, ~0u};
  MemoryRange first = memory.take(needs, false, "buffer"), second = memory.take(needs, false, "image");
  EXPECT_EQ(first.memory(), second.memory());
  EXPECT_EQ(first.offset(), 0u);
  EXPECT_EQ(second.offset(), 1u << 16);
}

TEST_F(BlockTest, OutOfMemoryNamesTheSizeAndARemedy) {
  most_bytes = 3 << 20;
  EXPECT_EQ(refusalOf(1 << 20), "") << "a smaller block is tried";
  const std::string refusal = refusalOf(6 << 20);
  EXPECT_NE(refusal.find("'numbers' takes 6 MiB, of "), std::string::npos) << refusal;
  EXPECT_NE(refusal.find(" free on device '" + device_.info().name + "'; nothing is drawn; end other programs"),
            std::string::npos)
      << refusal;
  most_bytes = UINT64_MAX;
  EXPECT_EQ(refusalOf(6 << 20), "") << "the device is usable after the refusal";
}

TEST_F(BlockTest, TooManyAllocationsAreRefusedByName) {
  callsOf(device_).GetPhysicalDeviceProperties2 = [](VkPhysicalDevice device, VkPhysicalDeviceProperties2* result) {
    properties(device, result);
    result->properties.limits.maxMemoryAllocationCount = 2;
  };
  std::vector<Buffer> large;
  for (int i = 0; i < 2; ++i) large.push_back(buffer(8 << 20, Buffer::Memory::Device));
  const std::string refusal = refusalOf(8 << 20);
  EXPECT_NE(refusal.find("'numbers' takes 8 MiB, and device '" + device_.info().name +
                         "' allows 2 allocations, all in use; nothing is drawn; "),
            std::string::npos)
      << refusal;
  large.pop_back();
  EXPECT_EQ(refusalOf(8 << 20), "");
}

TEST_F(BlockTest, DescriptorsBeyondTheDeviceAreRefusedByName) {
  callsOf(device_).GetPhysicalDeviceProperties2 = [](VkPhysicalDevice device, VkPhysicalDeviceProperties2* result) {
    properties(device, result);
    result->properties.limits.maxPerStageDescriptorSampledImages = 16;
    result->properties.limits.maxDescriptorSetStorageImages = 4;
    result->properties.limits.maxPerStageResources = 40;
  };
  EXPECT_EQ(limitsOf(device_).textures, 16u);
  auto refusal = [&](uint32_t textures, uint32_t images, uint32_t buffers) -> std::string {
    const VkShaderStageFlags all = VK_SHADER_STAGE_ALL;
    const std::vector<VkDescriptorSetLayoutBinding> scene = {
        {0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, textures, all, nullptr}};
    const std::vector<VkDescriptorSetLayoutBinding> pass = {
        {0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, all, nullptr},
        {1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, images, all, nullptr},
        {2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, buffers, all, nullptr}};
    try {
      requireDescriptors(device_, "edge", {scene, pass});
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(15, 4, 20), "");
  EXPECT_NE(refusal(16, 4, 1).find("'edge' and the scene use 17 textures and images read, of at most 16 on device '"),
            std::string::npos);
  EXPECT_NE(refusal(1, 5, 1).find("5 images written, of at most 4"), std::string::npos);
  EXPECT_NE(refusal(15, 4, 21).find("41 descriptors, of at most 40"), std::string::npos);
}

// Sizes of levels and buffers that are not multiples of the staging memory's parts.
TEST_F(BlockTest, UploadsAreFewAndWhole) {
  static size_t submissions;
  static PFN_vkQueueSubmit2 submit;
  submissions = 0;
  submit = std::exchange(callsOf(device_).QueueSubmit2,
                         [](VkQueue queue, uint32_t count, const VkSubmitInfo2* infos, VkFence fence) {
                           ++submissions;
                           return submit(queue, count, infos, fence);
                         });
  std::vector<Buffer> buffers;
  std::vector<DeviceImage> images;
  Uploads uploads(device_);
  for (uint32_t i = 0; i < 300; ++i) {
    buffers.push_back(uploads.array("array", std::vector<uint32_t>(1 + 37 * i, i), 0));
    const std::vector<std::vector<uint8_t>> levels = {std::vector<uint8_t>(3 * 5 * 4, uint8_t(i)),
                                                      std::vector<uint8_t>(1 * 2 * 4, uint8_t(i + 1))};
    images.push_back(
        uploads.image("image", {VK_FORMAT_R8G8B8A8_UNORM, 3, 5, 2, VK_IMAGE_USAGE_TRANSFER_SRC_BIT}, levels));
  }
  Buffer long_one = buffer(20'000'000, Buffer::Memory::Device);
  uploads.fill<uint32_t>(long_one, 0, 5'000'000, [](size_t i) { return uint32_t(i); });
  uploads.finish();
  EXPECT_LE(submissions, 3u);

  Buffer back = buffer(20'000'000);
  auto words = static_cast<const uint32_t*>(back.mapped());
  auto read = [&](const auto& record) {
    device_.submit([&](VkCommandBuffer commands) {
      record(commands);
      recordBarrier(device_, commands, {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                    {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT});
    });
  };
  for (uint32_t i = 0; i < 300; i += 13) {
    read([&](VkCommandBuffer commands) {
      VkBufferCopy all{0, 0, buffers[i].size()};
      device_.vk().CmdCopyBuffer(commands, buffers[i].handle(), back.handle(), 1, &all);
    });
    EXPECT_TRUE(std::all_of(words, words + 1 + 37 * i, [&](uint32_t word) { return word == i; })) << i;
    read([&](VkCommandBuffer commands) {
      VkBufferImageCopy level{};
      level.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 1, 0, 1};
      level.imageExtent = {1, 2, 1};
      device_.vk().CmdCopyImageToBuffer(commands, images[i].handle(), VK_IMAGE_LAYOUT_GENERAL, back.handle(), 1,
                                        &level);
    });
    EXPECT_EQ(words[0], (i + 1) % 256 * 0x01010101u) << i;
    EXPECT_EQ(words[1], words[0]) << i;
  }
  read([&](VkCommandBuffer commands) {
    VkBufferCopy all{0, 0, long_one.size()};
    device_.vk().CmdCopyBuffer(commands, long_one.handle(), back.handle(), 1, &all);
  });
  bool whole = true;
  for (uint32_t i = 0; i < 5'000'000; ++i) whole = whole && words[i] == i;
  EXPECT_TRUE(whole);
}

}  // namespace memory_test
}  // namespace strobe::gpu
