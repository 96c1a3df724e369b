// SPDX-License-Identifier: MIT
// How much of everything a device takes.
#pragma once

#include <cstdint>

#include "gpu/device.h"

namespace strobe::gpu {

struct DeviceLimits {
  uint64_t image_side = 0;    // px
  uint64_t buffer_bytes = 0;  // that a shader may see of one buffer
  uint64_t instances = 0;     // of an acceleration structure
  uint64_t geometries = 0;    // of a mesh
  uint64_t triangles = 0;     // of a mesh
};

DeviceLimits limitsOf(const Device& device);

}  // namespace strobe::gpu
