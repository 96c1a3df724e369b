// SPDX-License-Identifier: MIT
// Backends that trace rays. A new backend needs a row here, a file shaders/mixin/trace_NAME.glsl included by
// trace.glsl, and acceleration structures, unless the present ones can be used (world/structures.h).
#pragma once

#include <string>
#include <vector>

#include "gpu/device.h"

namespace strobe::shader {

// Ray tracing backend of a shader: none, ray tracing pipeline, ray queries, or traversal of the runtime's own BVH in
// GLSL.
enum class Backend { None, Pipeline, Query, Bvh };

// Kinds of acceleration structures: of the driver or of the runtime.
enum class StructureKind { Driver, Own };

// Properties of one tracing backend: name, required Vulkan feature, kind of acceleration structure, and GLSL macro and
// extensions.
struct BackendRow {
  Backend backend;
  const char* name;     // value of --backend
  const char* doc;      // description for users
  const char* feature;  // required Vulkan feature; "" for none
  StructureKind structures;
  bool has_stages;                      // runs in the stages of a ray tracing pipeline instead of compute
  bool has_doubles;                     // computes at double precision if the device supports it
  const char* define;                   // macro that is defined in GLSL
  std::vector<const char*> extensions;  // GLSL extensions
};

const std::vector<BackendRow>& backends();
const BackendRow& rowOf(Backend backend);
const char* backendName(Backend backend);  // "none" for Backend::None

bool isPresent(const BackendRow& row, const gpu::DeviceInfo& device);

// Selects a backend. `asked` is a name, or "auto" for the first row that the device supports. With "auto", the
// runtime's own structures come first on a software device and on a device without ray queries (docs/tracing.md has the
// times). Throws `Error` if the device does not support the backend.
Backend chooseBackend(const gpu::DeviceInfo& device, const std::string& asked);

}  // namespace strobe::shader
