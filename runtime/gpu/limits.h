// SPDX-License-Identifier: MIT
// Limits of a device: sizes, counts and memory.
#pragma once

#include <array>
#include <cstdint>

#include "base/limit.h"
#include "gpu/device.h"

namespace strobe::gpu {

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
};

DeviceLimits limitsOf(const Device& device);

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

inline constexpr std::array kLimits = {kInstanceLimit, kTriangleLimit, kGeometryLimit,
                                       kBufferLimit,   kMemoryLimit,   kImageLimit};

}  // namespace strobe::gpu
