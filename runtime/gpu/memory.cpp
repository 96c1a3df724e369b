// SPDX-License-Identifier: MIT
#include "gpu/memory.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/memory.h"
#include "gpu/limits.h"

namespace strobe::gpu {

// One allocation of the driver.
struct MemoryBlock {
  uint32_t type = 0;
  bool host = false;
  VkDeviceSize size = 0;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  char* mapped = nullptr;
  std::map<VkDeviceSize, VkDeviceSize> unused;  // size by offset; no two are adjacent

  // Takes the first unused range that is large enough, and returns its offset.
  std::optional<VkDeviceSize> take(VkDeviceSize bytes, VkDeviceSize alignment) {
    for (auto [begin, room] : unused) {  // a copy: the range is erased
      const VkDeviceSize offset = (begin + alignment - 1) / alignment * alignment, end = begin + room;
      if (offset + bytes > end) continue;
      unused.erase(begin);
      if (offset > begin) unused[begin] = offset - begin;
      if (end > offset + bytes) unused[offset + bytes] = end - offset - bytes;
      return offset;
    }
    return {};
  }

  void giveBack(VkDeviceSize offset, VkDeviceSize bytes) {
    auto range = unused.emplace(offset, bytes).first;
    auto next = std::next(range);
    if (next != unused.end() && offset + bytes == next->first) {
      range->second += next->second;
      unused.erase(next);
    }
    if (range == unused.begin()) return;
    auto before = std::prev(range);
    if (before->first + before->second != offset) return;
    before->second += range->second;
    unused.erase(range);
  }

  bool isUnused() const { return !unused.empty() && unused.begin()->second == size; }
};

MemoryRange& MemoryRange::operator=(MemoryRange&& other) noexcept {
  std::swap(owner_, other.owner_);
  std::swap(block_, other.block_);
  std::swap(offset_, other.offset_);
  std::swap(size_, other.size_);
  return *this;
}

MemoryRange::~MemoryRange() {
  if (owner_) owner_->giveBack(*this);
}

VkDeviceMemory MemoryRange::memory() const { return block_->memory; }

void* MemoryRange::mapped() const { return block_->mapped ? block_->mapped + offset_ : nullptr; }

DeviceMemory::DeviceMemory(const Device& device) : device_(device) {
  device.vk().GetPhysicalDeviceMemoryProperties(device.physical(), &types_);
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  device.vk().GetPhysicalDeviceProperties2(device.physical(), &properties);
  granularity_ = properties.properties.limits.bufferImageGranularity;
}

DeviceMemory::~DeviceMemory() {
  for (const auto& block : blocks_) free(*block);
}

size_t DeviceMemory::allocations() const {
  std::lock_guard lock(mutex_);
  return blocks_.size();
}

uint32_t DeviceMemory::typeOf(uint32_t type_bits, bool host) const {
  const VkMemoryPropertyFlags of_host = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  for (VkMemoryPropertyFlags wanted :
       {host ? of_host : VkMemoryPropertyFlags(VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT), host ? of_host : 0})
    for (uint32_t i = 0; i < types_.memoryTypeCount; ++i)
      if ((type_bits >> i & 1) && (types_.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
  throw Error(fmt::format("device '{}' has no memory of the required kind", device_.info().name));
}

// All ranges begin at multiples of the granularity, so that a buffer and an image never share a page of that size.
MemoryRange DeviceMemory::take(const VkMemoryRequirements& needs, bool host, const std::string& name) {
  const VkDeviceSize alignment = std::max(needs.alignment, granularity_);
  const uint32_t type = typeOf(needs.memoryTypeBits, host);
  std::lock_guard lock(mutex_);
  MemoryRange range;
  std::optional<VkDeviceSize> offset;
  for (const auto& block : blocks_) {
    if (block->type != type || block->host != host) continue;
    if (!(offset = block->take(needs.size, alignment))) continue;
    range.block_ = block.get();
    break;
  }
  if (!offset) {
    range.block_ = &addBlock(type, host, needs.size, name);
    offset = range.block_->take(needs.size, alignment);
  }
  range.owner_ = this, range.offset_ = *offset, range.size_ = needs.size;
  return range;
}

void DeviceMemory::giveBack(MemoryRange& range) {
  std::lock_guard lock(mutex_);
  MemoryBlock* block = range.block_;
  block->giveBack(range.offset_, range.size_);
  if (!block->isUnused()) return;
  free(*block);
  std::erase_if(blocks_, [&](const auto& held) { return held.get() == block; });
}

// Size of the next block of a kind with `total` bytes: the number of blocks grows with the logarithm of the memory, and
// at most an eighth of the memory is unused.
static VkDeviceSize usualSize(VkDeviceSize total) {
  constexpr VkDeviceSize kLeast = 4u << 20, kMost = 256u << 20;
  return std::clamp(total / 8, kLeast, kMost);
}

// Adds a block for at least `size` bytes. A large resource has a block of its own, which is freed with the resource.
MemoryBlock& DeviceMemory::addBlock(uint32_t type, bool host, VkDeviceSize size, const std::string& name) {
  const DeviceLimits limits = limitsOf(device_);
  const std::string& device = device_.info().name;
  if (blocks_.size() >= limits.allocations)
    throw Error(kAllocationLimit.text(fmt::format("'{}' takes {}, and device '{}' allows {} allocations, all in use",
                                                  name, bytesText(size), device, limits.allocations)));
  VkDeviceSize total = 0;
  for (const auto& block : blocks_)
    if (block->type == type && block->host == host) total += block->size;
  auto block = std::make_unique<MemoryBlock>();
  block->type = type, block->host = host;
  block->size = size > usualSize(total) / 2 ? size : usualSize(total);
  VkResult result = allocate(type, block->size, block->memory);
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY && block->size > size)
    result = allocate(type, block->size = size, block->memory);
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY)
    throw Error(kMemoryLimit.text(fmt::format("'{}' takes {}, of {} free on device '{}'", name, bytesText(size),
                                              bytesText(limits.memory_bytes), device)));
  device_.check(result, fmt::format("allocating {} for '{}'", bytesText(size), name));
  block->unused[0] = block->size;
  if (host) {
    void* mapped = nullptr;
    result = device_.vk().MapMemory(device_.handle(), block->memory, 0, VK_WHOLE_SIZE, 0, &mapped);
    if (result != VK_SUCCESS) free(*block);
    device_.check(result, fmt::format("mapping {} for '{}'", bytesText(block->size), name));
    block->mapped = static_cast<char*>(mapped);
  }
  blocks_.push_back(std::move(block));
  return *blocks_.back();
}

VkResult DeviceMemory::allocate(uint32_t type, VkDeviceSize size, VkDeviceMemory& memory) const {
  VkMemoryAllocateFlagsInfo flags{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO};
  flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, &flags};
  info.allocationSize = size;
  info.memoryTypeIndex = type;
  return device_.vk().AllocateMemory(device_.handle(), &info, nullptr, &memory);
}

void DeviceMemory::free(MemoryBlock& block) const { device_.vk().FreeMemory(device_.handle(), block.memory, nullptr); }

}  // namespace strobe::gpu
