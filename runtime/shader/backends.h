// SPDX-License-Identifier: MIT
// The ways of tracing rays. A further one is a row here, a file shaders/mixin/trace_NAME.glsl that trace.glsl includes,
// and structures for its rays unless those that are there serve (world/structures.h).
#pragma once

#include <string>
#include <vector>

#include "gpu/device.h"

namespace strobe::shader {

enum class Backend { None, Pipeline, Query, Bvh };

// What rays traverse.
enum class StructureKind { Driver, Own };

struct BackendRow {
  Backend backend;
  const char* name;     // as --backend has it
  const char* doc;      // what traces, for people
  const char* feature;  // of Vulkan, without which it does not run; "" for none
  StructureKind structures;
  bool has_stages;                      // runs in the stages of a ray tracing pipeline instead of compute
  bool has_doubles;                     // computes at double precision where the device can
  const char* define;                   // by which GLSL knows it
  std::vector<const char*> extensions;  // of GLSL
};

const std::vector<BackendRow>& backends();
const BackendRow& rowOf(Backend backend);
const char* backendName(Backend backend);  // "none" of None

bool isPresent(const BackendRow& row, const gpu::DeviceInfo& device);

// `asked`: a name, or "auto", the first that the device has in the order of the rows; on a software device, and on one
// without ray queries, the runtime's own structures come first (docs/tracing.md has the times). Throws `Error` where
// the device cannot do what is asked for.
Backend chooseBackend(const gpu::DeviceInfo& device, const std::string& asked);

}  // namespace strobe::shader
