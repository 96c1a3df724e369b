// SPDX-License-Identifier: MIT
// A Vulkan driver for tests of captures with RenderDoc: Mesa's software device that also reports the feature
// bufferDeviceAddressCaptureReplay. Captures are complete, but cannot be replayed: on replay, buffers get other
// addresses.
#include <dlfcn.h>

#include <string_view>

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan.h>

namespace {

template <class Function>
Function ofMesa(const char* name) {
  static void* const library = dlopen("libvulkan_lvp.so", RTLD_NOW | RTLD_LOCAL);
  return reinterpret_cast<Function>(dlsym(library, name));
}

PFN_vkGetPhysicalDeviceFeatures2 mesa_features = nullptr;
PFN_vkCreateDevice mesa_create_device = nullptr;

// Sets the feature in a chain of structures. The driver refuses a device with a feature that it lacks.
void setCaptureReplay(const void* chain, VkBool32 value) {
  for (auto* at = static_cast<VkBaseOutStructure*>(const_cast<void*>(chain)); at; at = at->pNext)
    if (at->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES)
      reinterpret_cast<VkPhysicalDeviceVulkan12Features*>(at)->bufferDeviceAddressCaptureReplay = value;
    else if (at->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES)
      reinterpret_cast<VkPhysicalDeviceBufferDeviceAddressFeatures*>(at)->bufferDeviceAddressCaptureReplay = value;
}

VKAPI_ATTR void VKAPI_CALL getFeatures(VkPhysicalDevice device, VkPhysicalDeviceFeatures2* features) {
  mesa_features(device, features);
  setCaptureReplay(features->pNext, VK_TRUE);
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
  setCaptureReplay(info->pNext, VK_FALSE);
  return mesa_create_device(physical, info, allocator, device);
}

}  // namespace

// NOLINTBEGIN(readability-identifier-naming): the loader of Vulkan requires these names
extern "C" {

VKAPI_ATTR VkResult VKAPI_CALL vk_icdNegotiateLoaderICDInterfaceVersion(uint32_t* version) {
  return ofMesa<VkResult (*)(uint32_t*)>("vk_icdNegotiateLoaderICDInterfaceVersion")(version);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vk_icdGetInstanceProcAddr(VkInstance instance, const char* name) {
  static const auto mesa = ofMesa<PFN_vkGetInstanceProcAddr>("vk_icdGetInstanceProcAddr");
  PFN_vkVoidFunction found = mesa(instance, name);
  if (!found) return nullptr;
  if (std::string_view(name).starts_with("vkGetPhysicalDeviceFeatures2")) {
    mesa_features = reinterpret_cast<PFN_vkGetPhysicalDeviceFeatures2>(found);
    return reinterpret_cast<PFN_vkVoidFunction>(getFeatures);
  }
  if (std::string_view(name) == "vkCreateDevice") {
    mesa_create_device = reinterpret_cast<PFN_vkCreateDevice>(found);
    return reinterpret_cast<PFN_vkVoidFunction>(createDevice);
  }
  return found;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vk_icdGetPhysicalDeviceProcAddr(VkInstance instance, const char* name) {
  return vk_icdGetInstanceProcAddr(instance, name);
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
