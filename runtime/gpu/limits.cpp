// SPDX-License-Identifier: MIT
#include "gpu/limits.h"

namespace strobe::gpu {

DeviceLimits limitsOf(const Device& device) {
  VkPhysicalDeviceAccelerationStructurePropertiesKHR structures{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &structures, {}};
  device.vk().GetPhysicalDeviceProperties2(device.physical(), &properties);
  const VkPhysicalDeviceLimits& limits = properties.properties.limits;
  return {limits.maxImageDimension2D, limits.maxStorageBufferRange, structures.maxInstanceCount,
          structures.maxGeometryCount, structures.maxPrimitiveCount};
}

}  // namespace strobe::gpu
