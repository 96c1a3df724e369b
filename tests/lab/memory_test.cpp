// SPDX-License-Identifier: MIT
// Memory of a frame, summed before the first allocation.
#include <gtest/gtest.h>

#include "common/home.h"
#include "common/refusal.h"
#include "lab/batch.h"
#include "oracle/render.h"

namespace strobe::lab {
namespace memory_test {

uint64_t allocated = 0;
PFN_vkAllocateMemory allocate = nullptr;

VkResult counted(VkDevice device, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks* callbacks,
                 VkDeviceMemory* memory) {
  allocated += info->allocationSize;
  return allocate(device, info, callbacks, memory);
}

class FrameMemory : public ::testing::Test {
 protected:
  FrameMemory() : bench_(home(), gpu::DeviceOptions{}) {
    auto& calls = const_cast<gpu::Dispatch&>(bench_.device().vk());
    allocate = std::exchange(calls.AllocateMemory, counted);
    allocated = 0;
  }
  graph::ImageBytes bytesOf(const Shot& shot) {
    return graph::Graph::bytes(*Batch(bench_).planOf(shot), bench_.frames_in_flight);
  }
  std::string refusalOf(const Shot& shot) {
    return testing::refusalOf([&] { bench_.render(shot); });
  }

  Workbench bench_;
  // The scene is one quad: the frame takes nearly all memory.
  Shot shot_ = oracle::with(oracle::shotOf("half_plane", 640, 360, {{"edge", 320}, {"d_f", 20}}), "mcguire2012");
};

// The sum matches the allocated bytes, with some room for padding, parameter buffers and uploads.
TEST_F(FrameMemory, MatchesTheAllocations) {
  const graph::ImageBytes bytes = bytesOf(shot_);
  allocated = 0;
  bench_.render(shot_);
  EXPECT_GT(allocated, bytes.on_device + bytes.read_back);
  EXPECT_LT(double(allocated), 1.1 * double(bytes.on_device + bytes.read_back) + 24e6);
  EXPECT_GT(bytes.pictures, 640u * 360 * 4 * sizeof(float)) << "more than the colour image";
}

TEST_F(FrameMemory, IsRefusedBeforeTheFirstAllocation) {
  const graph::ImageBytes bytes = bytesOf(shot_);
  const uint64_t least =
      bytes.on_device + (bench_.device().info().shares_memory ? bytes.read_back + bytes.pictures : 0);
  allocated = 0;
  bench_.most_bytes = least - 1;
  const std::string refusal = refusalOf(shot_);
  EXPECT_EQ(allocated, 0u);
  EXPECT_NE(refusal.find("mcguire2012 at 640x360 takes "), std::string::npos) << refusal;
  EXPECT_NE(refusal.find(" available on device '" + bench_.device().info().name + "'"), std::string::npos) << refusal;
  EXPECT_EQ(std::count(refusal.begin(), refusal.end(), '\n'), 0) << refusal;
  bench_.most_bytes = least + (8u << 20);
  EXPECT_EQ(refusalOf(shot_), "");
  EXPECT_GT(allocated, 0u);
}

}  // namespace memory_test
}  // namespace strobe::lab
