// SPDX-License-Identifier: MIT
// Tests whether a scene fits a device, before any allocation.
#pragma once

#include "gpu/limits.h"
#include "scene/scene.h"
#include "shader/backends.h"

namespace strobe::world {

// Throws an `Error` that names every device limit exceeded by the scene with `slices` poses.
void requireFits(const scene::Scene& scene, uint32_t slices, const gpu::DeviceLimits& limits);

// Throws `Error` if the data that no pose changes exceeds the free memory, or if the scene has more triangles than the
// runtime's own trees can number.
void requireMemory(const scene::Scene& scene, shader::StructureKind structures, const gpu::DeviceLimits& limits);

// Bytes of a scene on a device: data that no pose changes, without driver structures; and `slices` poses.
uint64_t unposedBytes(const scene::Scene& scene, shader::StructureKind structures);
uint64_t posedBytes(const scene::Scene& scene, uint32_t slices);

}  // namespace strobe::world
