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
       false,
       "STROBE_BACKEND_QUERY",
       {"GL_EXT_ray_query"}},
      {Backend::Pipeline,
       "pipeline",
       "ray tracing pipelines",
       "rayTracingPipeline",
       StructureKind::Driver,
       true,
       false,
       "STROBE_BACKEND_PIPELINE",
       {"GL_EXT_ray_tracing"}},
      {Backend::Bvh,
       "bvh",
       "the runtime's own tree in compute, on any device",
       "",
       StructureKind::Own,
       false,
       true,
       "STROBE_BACKEND_BVH",
       {}},
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

static const BackendRow& rowNamed(const std::string& name) {
  std::vector<std::string> names = {"auto"};
  for (const BackendRow& row : backends()) {
    if (row.name == name) return row;
    names.push_back(row.name);
  }
  throw Error(fmt::format("unknown tracing backend '{}'{}", name, didYouMean(name, names)));
}

static Backend firstPresent(const gpu::DeviceInfo& device) {
  std::vector<BackendRow> rows = backends();
  // Devices with ray tracing hardware have ray queries. Other devices traverse driver structures in software too.
  if (device.software || !device.has("rayQuery"))
    std::stable_partition(rows.begin(), rows.end(),
                          [](const BackendRow& row) { return row.structures == StructureKind::Own; });
  for (const BackendRow& row : rows)
    if (isPresent(row, device)) return row.backend;
  STROBE_ASSERT(false, "a row needs no feature");
  return Backend::None;
}

Backend chooseBackend(const gpu::DeviceInfo& device, const std::string& asked) {
  if (asked == "auto") return firstPresent(device);
  const BackendRow& row = rowNamed(asked);
  if (isPresent(row, device)) return row.backend;
  throw Error(fmt::format("device '{}' has no {}, which tracing backend '{}' needs; use --backend auto", device.name,
                          row.feature, asked));
}

}  // namespace strobe::shader
