// SPDX-License-Identifier: MIT
// Commands that are recorded, submitted, and waited for when what they did is needed.
#pragma once

#include <functional>
#include <string>

#include "gpu/resources.h"

namespace strobe::gpu {

// One command buffer, and whether the device has executed it. The device must outlive it.
class Commands {
 public:
  Commands() = default;
  Commands(const Device& device, const std::string& name);
  Commands(Commands&& other) noexcept { *this = std::move(other); }
  Commands& operator=(Commands&& other) noexcept;
  // Waits for what was submitted.
  ~Commands();

  // Records with `record` and submits, behind all that was submitted before. What was submitted through this one must
  // have been waited for.
  void submit(const std::function<void(VkCommandBuffer)>& record);
  // Waits for the submitted commands, unless they were waited for already. Throws `DeviceLost`. `what` is the name of
  // the work in the message of an overrun; `allowance_s` is added to its time limit (`Device::setTimeLimit`).
  void wait(const std::string& what = "", double allowance_s = 0);
  // Submitted, and not waited for.
  bool isPending() const { return pending_; }

 private:
  const Device* device_ = nullptr;
  Owned<VkCommandPool> pool_;
  Owned<VkFence> fence_;
  VkCommandBuffer buffer_ = VK_NULL_HANDLE;
  bool pending_ = false;
};

}  // namespace strobe::gpu
