// SPDX-License-Identifier: MIT
// Data staged by the host reaches the device in order with the work that reads it, with any number of frames in flight.
#include "gpu/staging.h"

#include <gtest/gtest.h>

#include "gpu/commands.h"

namespace strobe::gpu {
namespace staging_test {

constexpr size_t kInFlight = 3, kWords = 400000;  // more than a part of the staging memory

struct Frame {
  Commands commands;
  Staging staging;
  Buffer back;
};

std::vector<uint32_t> wordsOf(const Buffer& buffer) {
  std::vector<uint32_t> words(kWords);
  std::memcpy(words.data(), buffer.mapped(), kWords * 4);
  return words;
}

TEST(Staging, EachFrameReadsItsOwnWrites) {
  Device device({.validation = true});
  Buffer shared(device, "shared", kWords * 4, 0, Buffer::Memory::Device);
  std::vector<Frame> frames;
  for (size_t i = 0; i < kInFlight; ++i)
    frames.push_back(
        {Commands(device, "frame"), Staging(device), Buffer(device, "back", kWords * 4, 0, Buffer::Memory::Host)});
  std::vector<uint32_t> words(kWords);  // device content after all frames so far
  std::vector<std::vector<uint32_t>> wanted;
  auto expect_first = [&] {
    Frame& frame = frames[(wanted.size() - 1) % kInFlight];
    frame.commands.wait();
    EXPECT_FALSE(frame.commands.isPending());
    EXPECT_TRUE(wordsOf(frame.back) == wanted.back()) << "frame " << wanted.size();
    frame.staging.reset();
  };
  std::vector<std::vector<uint32_t>> begun;
  for (uint32_t n = 0; n < 8; ++n) {
    if (n >= kInFlight) {
      wanted.push_back(begun[wanted.size()]);
      expect_first();
    }
    Frame& frame = frames[n % kInFlight];
    // All words in the first frame, then one word in every other frame.
    const size_t first = n == 0 ? 0 : 1000 * n, count = n == 0 ? kWords : n % 2;
    for (size_t i = first; i < first + count; ++i) words[i] = n + uint32_t(i);
    frame.staging.write(shared, first, words.data() + first, count);
    EXPECT_EQ(frame.staging.isEmpty(), count == 0);
    frame.commands.submit([&](VkCommandBuffer commands) {
      frame.staging.recordCopies(commands);
      VkBufferCopy all{0, 0, kWords * 4};
      device.vk().CmdCopyBuffer(commands, shared.handle(), frame.back.handle(), 1, &all);
      recordBarrier(device, commands, {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                    {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT});
    });
    EXPECT_TRUE(frame.staging.isEmpty());
    begun.push_back(words);
  }
  while (wanted.size() < begun.size()) {
    wanted.push_back(begun[wanted.size()]);
    expect_first();
  }
  EXPECT_EQ(device.takeMessages(), std::vector<std::string>());
}

TEST(Staging, DropsUnrecordedWrites) {
  Device device({.validation = true});
  Buffer buffer(device, "buffer", 16, 0, Buffer::Memory::Device);
  Staging staging(device);
  const uint32_t word = 1;
  staging.write(buffer, 2, &word, 1);
  staging.write(buffer, 3, &word, 0);
  EXPECT_FALSE(staging.isEmpty());
  staging.reset();
  EXPECT_TRUE(staging.isEmpty());
}

// Destroying commands waits for them.
TEST(Commands, AreAwaitedOnDestruction) {
  Device device({.validation = true});
  Buffer to(device, "to", 1 << 20, 0, Buffer::Memory::Host);
  {
    Commands commands(device, "commands");
    commands.submit([&](VkCommandBuffer buffer) {
      device.vk().CmdFillBuffer(buffer, to.handle(), 0, VK_WHOLE_SIZE, 7);
      recordBarrier(device, buffer, {VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                    {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT});
    });
    Commands moved = std::move(commands);
    EXPECT_TRUE(moved.isPending());
    EXPECT_FALSE(commands.isPending());  // NOLINT(bugprone-use-after-move): empty by contract
  }
  EXPECT_EQ(static_cast<const uint32_t*>(to.mapped())[(1 << 18) - 1], 7u);
  EXPECT_EQ(device.takeMessages(), std::vector<std::string>());
}

}  // namespace staging_test
}  // namespace strobe::gpu
