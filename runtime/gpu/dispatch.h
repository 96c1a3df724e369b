// SPDX-License-Identifier: MIT
// Table of all Vulkan functions that Strobe calls.
#pragma once

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan.h>

namespace strobe::gpu {

// Formatted by hand: clang-format puts one call per line.
// clang-format off
#define STROBE_INSTANCE_CALLS(X)                                                                                \
  X(DestroyInstance) X(EnumeratePhysicalDevices) X(GetPhysicalDeviceProperties2) X(GetPhysicalDeviceFeatures2)  \
  X(GetPhysicalDeviceMemoryProperties) X(GetPhysicalDeviceMemoryProperties2)                                    \
  X(GetPhysicalDeviceQueueFamilyProperties) X(GetPhysicalDeviceFormatProperties)                                \
  X(EnumerateDeviceExtensionProperties) X(CreateDevice) X(GetDeviceProcAddr)

// Null without the layer or extension.
#define STROBE_OPTIONAL_INSTANCE_CALLS(X) \
  X(CreateDebugUtilsMessengerEXT) X(DestroyDebugUtilsMessengerEXT) X(SetDebugUtilsObjectNameEXT) \
  X(CmdBeginDebugUtilsLabelEXT) X(CmdEndDebugUtilsLabelEXT)                                     \
  X(DestroySurfaceKHR) X(GetPhysicalDeviceSurfaceSupportKHR) X(GetPhysicalDeviceSurfaceCapabilitiesKHR) \
  X(GetPhysicalDeviceSurfaceFormatsKHR)

#define STROBE_DEVICE_CALLS(X)                                                                                   \
  X(DestroyDevice) X(GetDeviceQueue) X(DeviceWaitIdle) X(QueueSubmit2) X(CreateFence) X(DestroyFence)            \
  X(WaitForFences) X(ResetFences) X(CreateCommandPool) X(DestroyCommandPool) X(AllocateCommandBuffers)           \
  X(BeginCommandBuffer) X(EndCommandBuffer) X(ResetCommandPool) X(AllocateMemory) X(FreeMemory) X(MapMemory)     \
  X(CreateBuffer) X(DestroyBuffer) X(GetBufferMemoryRequirements) X(BindBufferMemory) X(GetBufferDeviceAddress)  \
  X(CreateImage) X(DestroyImage) X(GetImageMemoryRequirements) X(BindImageMemory) X(CreateImageView)             \
  X(DestroyImageView) X(CreateSampler) X(DestroySampler) X(CreateShaderModule) X(DestroyShaderModule)            \
  X(CreateDescriptorSetLayout) X(DestroyDescriptorSetLayout) X(CreatePipelineLayout) X(DestroyPipelineLayout)    \
  X(CreateComputePipelines) X(CreateGraphicsPipelines) X(DestroyPipeline) X(CreateDescriptorPool)                \
  X(DestroyDescriptorPool) X(AllocateDescriptorSets) X(UpdateDescriptorSets) X(CreateQueryPool)                  \
  X(DestroyQueryPool) X(GetQueryPoolResults) X(CmdPipelineBarrier2) X(CmdBindPipeline) X(CmdBindDescriptorSets)  \
  X(CmdDispatch) X(CmdDispatchIndirect) X(CmdBeginRendering) X(CmdEndRendering) X(CmdSetViewport) X(CmdSetScissor)                      \
  X(CmdBindIndexBuffer) X(CmdDraw) X(CmdDrawIndexed) X(CmdCopyBuffer) X(CmdCopyBufferToImage)                   \
  X(CmdCopyImageToBuffer) X(CmdClearColorImage) X(CmdFillBuffer) X(CmdResetQueryPool) X(CmdWriteTimestamp2)          \
  X(CmdBindVertexBuffers) X(CmdPushConstants) X(CmdCopyImage)

// Null on a device without ray tracing.
#define STROBE_RAY_CALLS(X)                                                                                    \
  X(CreateAccelerationStructureKHR) X(DestroyAccelerationStructureKHR) X(GetAccelerationStructureBuildSizesKHR) \
  X(GetAccelerationStructureDeviceAddressKHR) X(CmdBuildAccelerationStructuresKHR)                             \
  X(CmdCopyAccelerationStructureKHR) X(CmdWriteAccelerationStructuresPropertiesKHR)                            \
  X(CreateRayTracingPipelinesKHR) X(GetRayTracingShaderGroupHandlesKHR) X(CmdTraceRaysKHR)

// Null on a device created without a window.
#define STROBE_WINDOW_CALLS(X)                                                        \
  X(CreateSwapchainKHR) X(DestroySwapchainKHR) X(GetSwapchainImagesKHR)               \
  X(AcquireNextImageKHR) X(QueuePresentKHR)
// clang-format on

// Pointers to the loaded Vulkan functions of one instance and device; null for optional functions that are not
// available.
struct Dispatch {
#define X(name) PFN_vk##name name = nullptr;
  STROBE_INSTANCE_CALLS(X)
  STROBE_OPTIONAL_INSTANCE_CALLS(X)
  STROBE_DEVICE_CALLS(X)
  STROBE_RAY_CALLS(X)
  STROBE_WINDOW_CALLS(X)
#undef X
};

}  // namespace strobe::gpu
