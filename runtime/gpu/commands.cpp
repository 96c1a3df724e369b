// SPDX-License-Identifier: MIT
#include "gpu/commands.h"

namespace strobe::gpu {

Commands::Commands(const Device& device, const std::string& name) : device_(&device) {
  const Dispatch& vk = device.vk();
  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  pool.queueFamilyIndex = device.queueFamily();
  pool_ = create(device, VK_OBJECT_TYPE_COMMAND_POOL, vk.CreateCommandPool, vk.DestroyCommandPool, pool, "command pool",
                 name);
  VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocate.commandPool = pool_.get();
  allocate.commandBufferCount = 1;
  check(vk.AllocateCommandBuffers(device.handle(), &allocate, &buffer_), "allocating commands " + name);
  VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  fence_ = create(device, VK_OBJECT_TYPE_FENCE, vk.CreateFence, vk.DestroyFence, fence, "fence", name);
}

Commands& Commands::operator=(Commands&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(pool_, other.pool_);
  std::swap(fence_, other.fence_);
  std::swap(buffer_, other.buffer_);
  std::swap(pending_, other.pending_);
  return *this;
}

Commands::~Commands() {
  VkFence fence = fence_.get();
  if (!pending_) return;
  VkResult waited = device_->vk().WaitForFences(device_->handle(), 1, &fence, VK_TRUE, device_->limitNs(0));
  if (waited == VK_TIMEOUT) device_->overrun("");
}

void Commands::submit(const std::function<void(VkCommandBuffer)>& record) {
  STROBE_ASSERT(!pending_, "commands are submitted twice");
  const Dispatch& vk = device_->vk();
  check(vk.ResetCommandPool(device_->handle(), pool_.get(), 0), "resetting the command pool");
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vk.BeginCommandBuffer(buffer_, &begin), "beginning commands");
  record(buffer_);
  check(vk.EndCommandBuffer(buffer_), "ending commands");

  VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  buffer.commandBuffer = buffer_;
  VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  submit.commandBufferInfoCount = 1;
  submit.pCommandBufferInfos = &buffer;
  device_->check(vk.QueueSubmit2(device_->queue(), 1, &submit, fence_.get()), "submitting commands");
  pending_ = true;
}

void Commands::wait(const std::string& what, double allowance_s) {
  if (!pending_) return;
  VkFence fence = fence_.get();
  VkResult waited = device_->vk().WaitForFences(device_->handle(), 1, &fence, VK_TRUE, device_->limitNs(allowance_s));
  if (waited == VK_TIMEOUT) device_->overrun(what);
  pending_ = false;  // also if lost: a lost device executes nothing
  device_->check(waited, "waiting for the device");
  check(device_->vk().ResetFences(device_->handle(), 1, &fence), "resetting the fence");
}

}  // namespace strobe::gpu
