// SPDX-License-Identifier: MIT
// Lost devices, and work that never ends.
#include <gtest/gtest.h>

#include "gpu/commands.h"
#include "gpu/device.h"

namespace strobe::gpu {
namespace lost_test {

// The dispatch table of all Vulkan calls, writable so that a test can replace a call.
Dispatch& callsOf(Device& device) { return const_cast<Dispatch&>(device.vk()); }

std::string lossOf(Device& device) {
  try {
    device.submit([](VkCommandBuffer) {});
  } catch (const Error& error) {
    ADD_FAILURE() << "not a DeviceLost error: " << error.what();
  } catch (const DeviceLost& lost) {
    return lost.what();
  }
  return "";
}

TEST(LostDevice, IsNamedWithItsSubject) {
  Device device;
  EXPECT_EQ(lossOf(device), "");
  callsOf(device).WaitForFences = [](VkDevice, uint32_t, const VkFence*, VkBool32, uint64_t) {
    return VK_ERROR_DEVICE_LOST;
  };
  EXPECT_EQ(lossOf(device), "the device '" + device.info().name +
                                "' was lost (waiting for the device): its driver failed or was reset");
}

TEST(LostDevice, IsDetectedOnSubmission) {
  Device device;
  device.setSubject("bar, hybrid");
  callsOf(device).QueueSubmit2 = [](VkQueue, uint32_t, const VkSubmitInfo2*, VkFence) { return VK_ERROR_DEVICE_LOST; };
  EXPECT_NE(lossOf(device).find("bar, hybrid: the device '"), std::string::npos);
  EXPECT_THROW(check(VK_ERROR_DEVICE_LOST, "reading"), DeviceLost);
  EXPECT_THROW(check(VK_ERROR_OUT_OF_HOST_MEMORY, "reading"), Error);
}

VkResult timesOut(VkDevice, uint32_t, const VkFence*, VkBool32, uint64_t limit_ns) {
  return limit_ns == UINT64_MAX ? VK_SUCCESS : VK_TIMEOUT;
}

// Applies to every program, with or without a handler; a handler receives the same text.
TEST(TimeLimit, EndsTheProgramAndNamesTheWork) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  auto work = [](double limit_s, const Device::OnOverrun& on_overrun) {
    Device device;
    callsOf(device).WaitForFences = timesOut;
    if (limit_s != kTimeLimit_s || on_overrun) device.setTimeLimit(limit_s, on_overrun);
    device.setSubject("bar, hybrid");
    device.submit([](VkCommandBuffer) {}, "edge");
    std::_Exit(0);
  };
  EXPECT_EXIT(work(kTimeLimit_s, {}), ::testing::ExitedWithCode(1),
              "strobe: bar, hybrid: 'edge' ran for more than 600 s on the device");
  auto say = [](const std::string& text) {
    std::fprintf(stderr, "%s; all is kept", text.c_str());
    std::_Exit(3);
  };
  EXPECT_EXIT(work(2, say), ::testing::ExitedWithCode(3), "'edge' ran for more than 2 s on the device; all is kept");
  EXPECT_EXIT(work(0, {}), ::testing::ExitedWithCode(0), "");
}

}  // namespace lost_test
}  // namespace strobe::gpu
