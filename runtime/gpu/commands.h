// SPDX-License-Identifier: MIT
// A command buffer that is recorded, submitted and later waited for.
#pragma once

#include <functional>
#include <string>

#include "gpu/resources.h"

namespace strobe::gpu {

// One command buffer and its execution state. The device must outlive it.
class Commands {
 public:
  Commands() = default;
  Commands(const Device& device, const std::string& name);
  Commands(Commands&& other) noexcept { *this = std::move(other); }
  Commands& operator=(Commands&& other) noexcept;
  // Waits for the last submission.
  ~Commands();

  // Records with `record` and submits, after all earlier submissions. The previous submission of this object must have
  // been waited for.
  void submit(const std::function<void(VkCommandBuffer)>& record);
  // Waits for the submitted commands, unless already waited for. Throws `DeviceLost`. `what` names the work if the time
  // limit is exceeded; `allowance_s` is added to the time limit (`Device::setTimeLimit`).
  void wait(const std::string& what = "", double allowance_s = 0);
  // True if submitted and not waited for.
  bool isPending() const { return pending_; }

 private:
  const Device* device_ = nullptr;
  Owned<VkCommandPool> pool_;
  Owned<VkFence> fence_;
  VkCommandBuffer buffer_ = VK_NULL_HANDLE;
  bool pending_ = false;
};

}  // namespace strobe::gpu
