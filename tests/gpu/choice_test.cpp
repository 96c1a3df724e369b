// SPDX-License-Identifier: MIT
#include "gpu/choice.h"

#include <gtest/gtest.h>

namespace strobe::gpu {
namespace choice_test {

DeviceInfo gpu(const std::string& name, const std::string& uuid, const std::string& pci, uint32_t vendor = 0x10de) {
  DeviceInfo info;
  info.name = name, info.uuid = uuid, info.pci = pci, info.vendor = vendor;
  return info;
}

// A node with an integrated GPU, two GPUs that are not in bus order, and a software device.
std::vector<DeviceInfo> node() {
  DeviceInfo software = gpu("llvmpipe (LLVM 15)", "6d657361-3235-2e30-2e37-000000000000", "", 0x10005);
  software.software = true;
  return {gpu("NVIDIA L40S", "b1000000-0000-0000-0000-00000000000b", "0000:af:00.0"),
          gpu("Intel UHD", "c1000000-0000-0000-0000-00000000000c", "0000:00:02.0", 0x8086),
          gpu("NVIDIA L40S", "a1000000-0000-0000-0000-00000000000a", "0000:3b:00.0"), software};
}

size_t chosen(const std::string& wanted, const std::optional<std::string>& of_job = std::nullopt) {
  return chosenDevice(node(), wanted, of_job);
}

std::string refusal(const std::string& wanted, const std::optional<std::string>& of_job = std::nullopt) {
  try {
    chosen(wanted, of_job);
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), 2);
    return error.what();
  }
  return "";
}

TEST(DeviceChoice, IsByIndexNameUuidOrPciAddress) {
  EXPECT_EQ(chosen(""), 0u);
  EXPECT_EQ(chosen("1"), 1u);
  EXPECT_EQ(chosen("uhd"), 1u);
  EXPECT_EQ(chosen("a1000000-0000-0000-0000-00000000000a"), 2u);
  EXPECT_EQ(chosen("GPU-A1000000-0000-0000-0000-00000000000A"), 2u);
  EXPECT_EQ(chosen("GPU-a1"), 2u);
  for (const char* address : {"0000:3b:00.0", "3B:00.0", "3b:0", "00000000:3B:00.0"}) EXPECT_EQ(chosen(address), 2u);
  EXPECT_EQ(refusal("4"), "--device 4: the first device is 0, the last one 3");
  EXPECT_EQ(refusal("3c:00.0"),
            "--device '3c:00.0' matches none of 'NVIDIA L40S', 'Intel UHD', 'NVIDIA L40S', 'llvmpipe (LLVM 15)'");
}

TEST(DeviceChoice, FollowsTheJobsVariable) {
  EXPECT_EQ(chosen("", "0"), 2u) << "the first on the bus";
  EXPECT_EQ(chosen("", "1,0"), 0u);
  EXPECT_EQ(chosen("", "GPU-a1000000-0000-0000-0000-00000000000a"), 2u);
  EXPECT_EQ(chosen("uhd", "0"), 1u) << "the option wins";
  for (const char* none : {"", "-1", "NoDevFiles"}) EXPECT_EQ(chosen("", none), 3u) << none;
  EXPECT_EQ(refusal("", "2"), "CUDA_VISIBLE_DEVICES=2 matches none of the 2 GPUs here; --device chooses one");
  EXPECT_EQ(chosenDevice({node()[3]}, "", "2"), 0u) << "only a software device";
}

// The machine's own devices, chosen by UUID.
TEST(DeviceChoice, EveryListedDeviceHasAUuid) {
  for (const DeviceInfo& info : listDevices()) {
    ASSERT_EQ(info.uuid.size(), 36u);
    EXPECT_EQ(Device({.device = info.uuid}).info().name, info.name);
  }
}

}  // namespace choice_test
}  // namespace strobe::gpu
