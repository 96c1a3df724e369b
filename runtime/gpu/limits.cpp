// SPDX-License-Identifier: MIT
#include "gpu/limits.h"

#include <algorithm>
#include <map>

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

// Descriptors of a kind: of a stage and of all sets of a pipeline. All stages use the same descriptors.
static void takeDescriptors(const VkPhysicalDeviceLimits& limits, DeviceLimits& result) {
  auto least = [](std::initializer_list<uint32_t> counts) { return uint64_t(std::min(counts)); };
  result.textures = least({limits.maxPerStageDescriptorSamplers, limits.maxPerStageDescriptorSampledImages,
                           limits.maxDescriptorSetSamplers, limits.maxDescriptorSetSampledImages});
  result.storage_images = least({limits.maxPerStageDescriptorStorageImages, limits.maxDescriptorSetStorageImages});
  result.storage_buffers = least({limits.maxPerStageDescriptorStorageBuffers, limits.maxDescriptorSetStorageBuffers});
  result.uniform_buffers = least({limits.maxPerStageDescriptorUniformBuffers, limits.maxDescriptorSetUniformBuffers});
  result.descriptors = limits.maxPerStageResources;
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
  result.allocations = limits.maxMemoryAllocationCount;
  takeDescriptors(limits, result);
  if (!has_structures) return result;
  result.instances = structures.maxInstanceCount;
  result.geometries = structures.maxGeometryCount;
  result.triangles = structures.maxPrimitiveCount;
  result.structures = std::min(structures.maxPerStageDescriptorAccelerationStructures,
                               structures.maxDescriptorSetAccelerationStructures);
  return result;
}

void requireDescriptors(const Device& device, const std::string& pass,
                        const std::vector<std::vector<VkDescriptorSetLayoutBinding>>& sets) {
  std::map<VkDescriptorType, uint64_t> counts;
  uint64_t all = 0;
  for (const auto& bindings : sets)
    for (const VkDescriptorSetLayoutBinding& binding : bindings)
      counts[binding.descriptorType] += binding.descriptorCount, all += binding.descriptorCount;
  const DeviceLimits limits = limitsOf(device);
  std::vector<std::string> beyond;
  auto require = [&](uint64_t count, const char* unit, uint64_t most) {
    if (count <= most) return;
    beyond.push_back(kDescriptorLimit.text(fmt::format("'{}' and the scene use {} {}, of at most {} on device '{}'",
                                                       pass, count, unit, most, device.info().name)));
  };
  require(counts[VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER], "textures and images read", limits.textures);
  require(counts[VK_DESCRIPTOR_TYPE_STORAGE_IMAGE], "images written", limits.storage_images);
  require(counts[VK_DESCRIPTOR_TYPE_STORAGE_BUFFER], "storage buffers", limits.storage_buffers);
  require(counts[VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER], "uniform buffers", limits.uniform_buffers);
  require(counts[VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR], "acceleration structures", limits.structures);
  require(all, "descriptors", limits.descriptors);
  throwIfAny(beyond);
}

}  // namespace strobe::gpu
