// SPDX-License-Identifier: MIT
#include "scene/fits.h"

#include "base/limits.h"
#include "shared/scene.h"

namespace strobe::scene {

void requireFits(const Scene& scene, uint32_t slices, const gpu::DeviceLimits& limits) {
  std::vector<std::string> beyond;
  auto require = [&](const char* limit, const std::string& what, uint64_t count, uint64_t most) {
    if (count > most) beyond.push_back(limitText(limit, fmt::format("{} has {} of at most {}", what, count, most)));
  };
  uint64_t instances = instancesOf(scene).size(), vertices = 0, indices = 0;
  require("instances", scene.name + ": the scene", instances, limits.instances);
  for (const Mesh& mesh : scene.meshes) {
    uint64_t triangles = 0;
    for (const Geometry& geometry : mesh.geometries) {
      triangles += geometry.indices.size() / 3;
      vertices += geometry.vertices.size();
      indices += geometry.indices.size();
    }
    require("triangles", fmt::format("{}: mesh '{}'", scene.name, mesh.name), triangles, limits.triangles);
    require("geometries", fmt::format("{}: mesh '{}'", scene.name, mesh.name), mesh.geometries.size(), limits.geometries);
  }
  auto requireBytes = [&](const char* what, uint64_t bytes) {
    require("buffers", fmt::format("{}: the buffer of its {}", scene.name, what), bytes, limits.buffer_bytes);
  };
  requireBytes("vertices, in bytes,", vertices * sizeof(shared::SceneVertex));
  requireBytes("indices, in bytes,", indices * sizeof(uint32_t));
  requireBytes("transforms, in bytes,", instances * slices * sizeof(shared::SceneTransform));
  for (const Texture& texture : scene.textures) {
    std::string what = fmt::format("{}: a side of texture '{}'", scene.name, texture.name);
    require("images", what, uint64_t(std::max(texture.width, texture.height)), limits.image_side);
  }
  throwIfAny(beyond);
}

}  // namespace strobe::scene
