// SPDX-License-Identifier: MIT
#include "gpu/limits.h"

namespace strobe::gpu {

DeviceLimits limitsOf(const Device& device) {
  VkPhysicalDeviceAccelerationStructurePropertiesKHR structures{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR};
  const bool has_structures = device.info().has("accelerationStructure");
  VkPhysicalDeviceProperties2 properties{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, has_structures ? &structures : nullptr, {}};
  device.vk().GetPhysicalDeviceProperties2(device.physical(), &properties);
  const VkPhysicalDeviceLimits& limits = properties.properties.limits;
  DeviceLimits result{limits.maxImageDimension2D, limits.maxStorageBufferRange};
  if (!has_structures) return result;
  result.instances = structures.maxInstanceCount;
  result.geometries = structures.maxGeometryCount;
  result.triangles = structures.maxPrimitiveCount;
  return result;
}

}  // namespace strobe::gpu
