// SPDX-License-Identifier: MIT
// Table of the device features that the runtime uses, for the query and for device creation.
#pragma once

#include <vector>

#include "gpu/device.h"

namespace strobe::gpu {

// Chained feature structures; `chain()` returns the head for a query or for device creation.
struct FeatureChain {
  VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceAccelerationStructureFeaturesKHR acceleration{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR};
  VkPhysicalDeviceRayTracingPipelineFeaturesKHR ray_pipeline{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_FEATURES_KHR};
  VkPhysicalDeviceRayQueryFeaturesKHR ray_query{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR};

  // Links the structures whose extensions are named in `extensions`.
  VkPhysicalDeviceFeatures2* chain(const std::vector<std::string>& extensions);
};

// A device feature to enable: its Vulkan name, its use, its extension, and its member in the feature chain.
struct WantedFeature {
  const char* name;
  const char* provides;
  const char* extension;  // "" for core
  bool required;
  VkBool32& (*in)(FeatureChain&);
};

const std::vector<WantedFeature>& wantedFeatures();

// Extensions to enable among `available`: the extensions of wanted features, with their dependencies.
std::vector<const char*> wantedExtensions(const std::vector<std::string>& available);

}  // namespace strobe::gpu
