// SPDX-License-Identifier: MIT
// Whether a device takes a scene, asked before anything is allocated.
#pragma once

#include "gpu/limits.h"
#include "scene/scene.h"

namespace strobe::world {

// Throws `Error` naming every limit of the device that the scene is beyond, posed at `slices` times at once.
void requireFits(const scene::Scene& scene, uint32_t slices, const gpu::DeviceLimits& limits);

}  // namespace strobe::world
