// SPDX-License-Identifier: MIT
#include "world/fits.h"

#include "shared/scene.h"

namespace strobe::world {

using namespace scene;

void requireFits(const Scene& scene, uint32_t slices, const gpu::DeviceLimits& limits) {
  std::vector<std::string> beyond;
  auto require = [&](const Limit& limit, const std::string& where, uint64_t count, const char* unit, uint64_t most) {
    if (count <= most) return;
    beyond.push_back(limit.text(fmt::format("{}: {} has {} {} of at most {}", scene.name, where, count, unit, most)));
  };
  uint64_t instances = instancesOf(scene).size(), vertices = 0, indices = 0;
  require(gpu::kInstanceLimit, "the scene", instances, "instances", limits.instances);
  for (const Mesh& mesh : scene.meshes) {
    std::string where = fmt::format("mesh '{}'", mesh.name);
    uint64_t triangles = 0;
    for (const Geometry& geometry : mesh.geometries) {
      triangles += geometry.indices.size() / 3;
      vertices += geometry.vertices.size();
      indices += geometry.indices.size();
    }
    require(gpu::kTriangleLimit, where, triangles, "triangles", limits.triangles);
    require(gpu::kGeometryLimit, where, mesh.geometries.size(), "parts", limits.geometries);
  }
  auto requireBytes = [&](const char* what, uint64_t bytes) {
    require(gpu::kBufferLimit, fmt::format("the buffer of all {}", what), bytes, "bytes", limits.buffer_bytes);
  };
  requireBytes("vertices", vertices * sizeof(shared::SceneVertex));
  requireBytes("indices", indices * sizeof(uint32_t));
  requireBytes("transforms", instances * slices * sizeof(shared::SceneTransform));
  for (const Texture& texture : scene.textures)
    require(gpu::kImageLimit, fmt::format("texture '{}'", texture.name),
            uint64_t(std::max(texture.width, texture.height)), "pixels a side", limits.image_side);
  throwIfAny(beyond);
}

}  // namespace strobe::world
