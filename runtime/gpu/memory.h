// SPDX-License-Identifier: MIT
// Device memory in blocks that buffers and images share: drivers allow few allocations (4,096 are guaranteed) and are
// slow at each.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace strobe::gpu {

struct MemoryBlock;

// A range of a block, returned to the block at destruction. The device must outlive it.
class MemoryRange {
 public:
  MemoryRange() = default;
  MemoryRange(MemoryRange&& other) noexcept { *this = std::move(other); }
  MemoryRange& operator=(MemoryRange&& other) noexcept;
  ~MemoryRange();
  VkDeviceMemory memory() const;
  VkDeviceSize offset() const { return offset_; }
  // Host address of the range; null in device memory.
  void* mapped() const;

 private:
  friend DeviceMemory;
  DeviceMemory* owner_ = nullptr;
  MemoryBlock* block_ = nullptr;
  VkDeviceSize offset_ = 0, size_ = 0;
};

// Owns all memory of a device. Thread-safe. The device must outlive it.
class DeviceMemory {
 public:
  explicit DeviceMemory(const Device& device);
  ~DeviceMemory();
  DeviceMemory(const DeviceMemory&) = delete;

  // Memory for the buffer or image `name`: `host` is coherent and always mapped, otherwise local to the device. Throws
  // `Error` with the size if memory runs out or the device allows no more allocations.
  MemoryRange take(const VkMemoryRequirements& needs, bool host, const std::string& name);
  size_t allocations() const;

 private:
  friend MemoryRange;
  void giveBack(MemoryRange& range);
  MemoryBlock& addBlock(uint32_t type, bool host, VkDeviceSize size, const std::string& name);
  VkResult allocate(uint32_t type, VkDeviceSize size, VkDeviceMemory& memory) const;
  void free(MemoryBlock& block) const;
  uint32_t typeOf(uint32_t type_bits, bool host) const;

  const Device& device_;
  VkPhysicalDeviceMemoryProperties types_{};
  VkDeviceSize granularity_ = 1;
  mutable std::mutex mutex_;  // guards blocks_
  std::vector<std::unique_ptr<MemoryBlock>> blocks_;
};

}  // namespace strobe::gpu
