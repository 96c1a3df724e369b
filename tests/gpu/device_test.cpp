// SPDX-License-Identifier: MIT
#include "gpu/device.h"

#include <gtest/gtest.h>

#include "gpu/pipeline.h"
#include "gpu/staging.h"

namespace strobe::gpu {
namespace device_test {

DeviceInfo sufficient() {
  DeviceInfo info;
  info.features = {{"scalarBlockLayout", "shared structures", true, true}, {"rayQuery", "queries", false, false}};
  return info;
}

TEST(DeviceInfo, NamesMissingFeaturesAndTheirUse) {
  EXPECT_EQ(sufficient().missing(), "");
  DeviceInfo without_layout = sufficient();
  without_layout.features[0].present = false;
  EXPECT_EQ(without_layout.missing(), "scalarBlockLayout (shared structures)");
  EXPECT_TRUE(sufficient().has("scalarBlockLayout"));
  EXPECT_FALSE(sufficient().has("rayQuery"));
  EXPECT_FALSE(sufficient().has("rays"));
}

TEST(Device, CopiesDataWithoutAValidationMessage) {
  Device device({.validation = true});
  std::vector<uint32_t> values = {1, 2, 3, 5, 8};
  Uploads uploads(device);
  Buffer uploaded = uploads.array("values", values, 0);
  uploads.finish();
  Buffer back(device, "back", values.size() * 4, 0, Buffer::Memory::Host);
  device.submit([&](VkCommandBuffer commands) {
    VkBufferCopy copy{0, 0, back.size()};
    device.vk().CmdCopyBuffer(commands, uploaded.handle(), back.handle(), 1, &copy);
  });
  EXPECT_EQ(std::memcmp(back.mapped(), values.data(), values.size() * 4), 0);
  EXPECT_TRUE(device.takeMessages().empty());
}

// Tests rely on validation: it must report a mistake.
TEST(Device, ValidationReportsAMistake) {
  Device device({.validation = true});
  Buffer small(device, "small", 16, 0, Buffer::Memory::Host);
  device.submit([&](VkCommandBuffer commands) {
    VkBufferCopy copy{0, 8, 16};
    device.vk().CmdCopyBuffer(commands, small.handle(), small.handle(), 1, &copy);
  });
  EXPECT_FALSE(device.takeMessages().empty());
}

TEST(Device, UnknownNamesAreRefusedWithAListOfDevices) {
  try {
    Device device({.device = "nonesuch"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), 2);
    EXPECT_NE(std::string(error.what()).find("matches none of"), std::string::npos);
  }
}

// The clock wraps to 0 after its last value, any number of times.
TEST(TimeStamps, ContinueWhenTheClockWraps) {
  using Ticks = std::vector<uint64_t>;
  EXPECT_EQ(ticksSinceFirst({5, 9, 30}, 64), (Ticks{0, 4, 25}));
  EXPECT_EQ(ticksSinceFirst({250, 4, 2, 2}, 8), (Ticks{0, 10, 264, 264}));
  const uint64_t last = (uint64_t{1} << 36) - 1;
  EXPECT_EQ(ticksSinceFirst({last - 1, 3}, 36), (Ticks{0, 5}));
  EXPECT_EQ(ticksSinceFirst({UINT64_MAX, 0}, 64), (Ticks{0, 1}));
  EXPECT_EQ(ticksSinceFirst({}, 36), Ticks());
}

}  // namespace device_test
}  // namespace strobe::gpu
