// SPDX-License-Identifier: MIT
// Tests whether a scene fits a device, before any allocation.
#pragma once

#include "gpu/limits.h"
#include "scene/scene.h"
#include "shader/backends.h"

namespace strobe::world {

// Throws an `Error` that names every limit exceeded by the scene with `slices` poses: limits of the device, and of the
// runtime's own trees.
void requireFits(const scene::Scene& scene, uint32_t slices, shader::StructureKind structures,
                 const gpu::DeviceLimits& limits);

// Bytes of a scene on a device: data that no pose changes, without driver structures; and `slices` poses.
uint64_t unposedBytes(const scene::Scene& scene, shader::StructureKind structures);
uint64_t posedBytes(const scene::Scene& scene, uint32_t slices);

}  // namespace strobe::world
