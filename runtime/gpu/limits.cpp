// SPDX-License-Identifier: MIT
#include "gpu/limits.h"

#include <algorithm>

#include "base/memory.h"

namespace strobe::gpu {

// Free bytes of the largest device-local heap; its size if the device does not report free memory.
static uint64_t freeMemory(const Device& device) {
  VkPhysicalDeviceMemoryBudgetPropertiesEXT budget{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT};
  const bool measured = device.info().measures_memory;
  VkPhysicalDeviceMemoryProperties2 memory{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2, measured ? &budget : nullptr, {}};
  device.vk().GetPhysicalDeviceMemoryProperties2(device.physical(), &memory);
  uint64_t most = 0;
  for (uint32_t i = 0; i < memory.memoryProperties.memoryHeapCount; ++i) {
    const VkMemoryHeap& heap = memory.memoryProperties.memoryHeaps[i];
    if (!(heap.flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)) continue;
    uint64_t used = std::min(budget.heapUsage[i], budget.heapBudget[i]);
    most = std::max<uint64_t>(most, measured ? budget.heapBudget[i] - used : heap.size);
  }
  return most;
}

DeviceLimits limitsOf(const Device& device) {
  VkPhysicalDeviceAccelerationStructurePropertiesKHR structures{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR};
  const bool has_structures = device.info().has("accelerationStructure");
  VkPhysicalDeviceMaintenance4Properties buffers{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES,
                                                 has_structures ? &structures : nullptr};
  VkPhysicalDeviceMaintenance3Properties allocations{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES,
                                                     &buffers};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &allocations, {}};
  device.vk().GetPhysicalDeviceProperties2(device.physical(), &properties);
  const VkPhysicalDeviceLimits& limits = properties.properties.limits;
  DeviceLimits result{limits.maxImageDimension2D, limits.maxStorageBufferRange};
  result.array_bytes = std::min<uint64_t>(buffers.maxBufferSize, allocations.maxMemoryAllocationSize);
  result.host_bytes = availableMemory();
  result.memory_bytes = freeMemory(device);
  if (device.info().shares_memory) result.memory_bytes = std::min(result.memory_bytes, result.host_bytes);
  if (!has_structures) return result;
  result.instances = structures.maxInstanceCount;
  result.geometries = structures.maxGeometryCount;
  result.triangles = structures.maxPrimitiveCount;
  return result;
}

}  // namespace strobe::gpu
