// SPDX-License-Identifier: MIT
// Whether a device takes a scene, asked before anything is allocated.
#pragma once

#include "gpu/limits.h"
#include "scene/scene.h"
#include "shader/backends.h"

namespace strobe::world {

// Throws `Error` naming every limit of the device that the scene is beyond, posed at `slices` times at once.
void requireFits(const scene::Scene& scene, uint32_t slices, const gpu::DeviceLimits& limits);

// Throws `Error` where what no pose changes needs more memory than is free, or has more triangles than the runtime's
// own trees can number.
void requireMemory(const scene::Scene& scene, shader::StructureKind structures, const gpu::DeviceLimits& limits);

// Bytes of a scene on a device: the part that no pose changes, without structures of the driver, and `slices` poses.
uint64_t unposedBytes(const scene::Scene& scene, shader::StructureKind structures);
uint64_t posedBytes(const scene::Scene& scene, uint32_t slices);

}  // namespace strobe::world
