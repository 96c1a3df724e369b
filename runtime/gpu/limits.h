// SPDX-License-Identifier: MIT
// Limits of a device: sizes, counts and memory.
#pragma once

#include <array>
#include <cstdint>

#include "base/limit.h"
#include "gpu/device.h"

namespace strobe::gpu {

// Limits of one device: image side in pixels, buffer and memory sizes in bytes, and counts of objects; UINT64_MAX:
// unlimited.
struct DeviceLimits {
  uint64_t image_side = 0;            // px
  uint64_t buffer_bytes = 0;          // of a bound storage buffer
  uint64_t array_bytes = UINT64_MAX;  // of a buffer read by address
  // Free memory of the device; its size if the device does not report free memory. At most `host_bytes` if the device
  // uses the machine's memory.
  uint64_t memory_bytes = UINT64_MAX;
  uint64_t host_bytes = UINT64_MAX;  // free memory of the machine for this process
  uint64_t instances = UINT64_MAX;   // per acceleration structure; unlimited without hardware structures
  uint64_t geometries = UINT64_MAX;  // per mesh
  uint64_t triangles = UINT64_MAX;   // per mesh
  uint64_t allocations = UINT64_MAX;
  // Descriptors that one stage of a shader can use, and their sum.
  uint64_t textures = UINT64_MAX, storage_images = UINT64_MAX, storage_buffers = UINT64_MAX,
           uniform_buffers = UINT64_MAX, structures = UINT64_MAX, descriptors = UINT64_MAX;
};

DeviceLimits limitsOf(const Device& device);

// Throws `Error` if the shaders of a pass use more descriptors than the device allows. `sets`: bindings of each set.
void requireDescriptors(const Device& device, const std::string& pass,
                        const std::vector<std::vector<VkDescriptorSetLayoutBinding>>& sets);

inline constexpr Limit kInstanceLimit{
    "instances", Limit::Kind::Refused,
    "a scene has more instances than an acceleration structure of the device can hold",
    "nothing is drawn; merge meshes, or use another device"};
inline constexpr Limit kTriangleLimit{"triangles", Limit::Kind::Refused,
                                      "a mesh has more triangles than an acceleration structure of the device can hold",
                                      "nothing is drawn; split the mesh"};
inline constexpr Limit kGeometryLimit{"geometries", Limit::Kind::Refused,
                                      "a mesh has more parts than an acceleration structure of the device can hold",
                                      "nothing is drawn; merge the materials of the mesh, or split the mesh"};
inline constexpr Limit kBufferLimit{"buffers", Limit::Kind::Refused,
                                    "a buffer of a scene or a pass is larger than the device allows for one buffer",
                                    "nothing is drawn; use fewer vertices or instances, fewer `slices` of truth, a "
                                    "smaller picture, or another device"};
inline constexpr Limit kMemoryLimit{
    "memory", Limit::Kind::Refused, "a frame and its scene take more memory than is free on the device or the machine",
    "nothing is drawn; end other programs, use a smaller picture, fewer vertices or smaller textures, or another "
    "device"};
inline constexpr Limit kImageLimit{"images", Limit::Kind::Refused,
                                   "a picture or texture is larger than the largest image of the device",
                                   "nothing is drawn; use a smaller picture or texture"};
inline constexpr Limit kAllocationLimit{"allocations", Limit::Kind::Refused,
                                        "all memory allocations that the device allows are in use",
                                        "nothing is drawn; close other windows and scenes of the program, use fewer or "
                                        "smaller textures, or another device"};
inline constexpr Limit kTextureLimit{"textures", Limit::Kind::Refused,
                                     "a scene has more textures than a shader of the device can use",
                                     "nothing is drawn; join textures, remove unused ones, or use another device"};
inline constexpr Limit kDescriptorLimit{
    "descriptors", Limit::Kind::Refused,
    "a pass and the scene use more images, buffers or structures than a shader of the device can",
    "nothing is drawn; use fewer inputs and outputs of the pass, fewer textures, fewer `slices` of truth, or another "
    "device"};
inline constexpr Limit kTimestampLimit{"timestamps", Limit::Kind::Known,
                                       "the device has no time stamps, or one pass takes longer than they count",
                                       "Without time stamps each pass is timed with the clock of the host, its start "
                                       "included. A longer pass than the period of the time stamps appears too short; "
                                       "the period is at least a minute on common devices."};

inline constexpr std::array kLimits = {kInstanceLimit,   kTriangleLimit, kGeometryLimit,   kBufferLimit,
                                       kMemoryLimit,     kImageLimit,    kAllocationLimit, kTextureLimit,
                                       kDescriptorLimit, kTimestampLimit};

}  // namespace strobe::gpu
