// SPDX-License-Identifier: MIT
#include "shader/backends.h"

#include <algorithm>

namespace strobe::shader {

const std::vector<BackendRow>& backends() {
  static const std::vector<BackendRow> rows = {
      {Backend::Query,
       "query",
       "ray queries in compute",
       "rayQuery",
       StructureKind::Driver,
       false,
       "STROBE_BACKEND_QUERY",
       {"GL_EXT_ray_query"}},
      {Backend::Pipeline,
       "pipeline",
       "ray tracing pipelines",
       "rayTracingPipeline",
       StructureKind::Driver,
       true,
       "STROBE_BACKEND_PIPELINE",
       {"GL_EXT_ray_tracing"}},
      {Backend::Bvh,
       "bvh",
       "the runtime's own tree in compute, on any device",
       "",
       StructureKind::Own,
       false,
       "STROBE_BACKEND_BVH",
       {"GL_EXT_buffer_reference"}},
  };
  return rows;
}

const BackendRow& rowOf(Backend backend) {
  for (const BackendRow& row : backends())
    if (row.backend == backend) return row;
  STROBE_ASSERT(false, "no row of backend {}", int(backend));
  return backends().front();
}

const char* backendName(Backend backend) { return backend == Backend::None ? "none" : rowOf(backend).name; }

bool isPresent(const BackendRow& row, const gpu::DeviceInfo& device) {
  return !*row.feature || device.has(row.feature);
}

Backend chooseBackend(const gpu::DeviceInfo& device, const std::string& asked) {
  for (const BackendRow& row : backends()) {
    if (asked != "auto" && asked != row.name) continue;
    if (isPresent(row, device)) return row.backend;
    if (asked != "auto")
      throw Error(
          fmt::format("device '{}' has no {}, which tracing backend '{}' needs; --backend auto takes what there is",
                      device.name, row.feature, asked));
  }
  throw Error(fmt::format("there is no tracing backend '{}'", asked));
}

}  // namespace strobe::shader
