// SPDX-License-Identifier: MIT
#include "world/fits.h"

#include "scene/bend.h"
#include "shared/bvh.h"
#include "shared/scene.h"
#include "world/limits.h"

namespace strobe::world {

using namespace scene;

namespace {

struct GeometryCounts {
  uint64_t vertices = 0, tangents = 0, indices = 0, bending = 0;  // bending: of deformed instances
  explicit GeometryCounts(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes)
      for (const Geometry& geometry : mesh.geometries)
        vertices += geometry.vertices.size(), tangents += geometry.tangents.size(), indices += geometry.indices.size();
    for (const Instance& instance : instancesOf(scene))
      if (bends(scene, instance)) bending += vertexCount(scene, instance);
    vertices += bending;
  }
};

// Collects exceeded limits.
class Beyond {
 public:
  explicit Beyond(const Scene& scene) : scene_(scene) {}
  void require(const Limit& limit, const std::string& where, uint64_t count, const char* unit, uint64_t most) {
    if (count <= most) return;
    texts_.push_back(limit.text(fmt::format("{}: {} has {} {} of at most {}", scene_.name, where, count, unit, most)));
  }
  void finish() const { throwIfAny(texts_); }

 private:
  const Scene& scene_;
  std::vector<std::string> texts_;
};

uint64_t textureBytes(const Scene& scene) {
  uint64_t bytes = 0;
  for (const Texture& texture : scene.textures)
    for (const auto& level : texture.levels) bytes += level.size();
  return bytes;
}

}  // namespace

void requireFits(const Scene& scene, uint32_t slices, shader::StructureKind structures,
                 const gpu::DeviceLimits& limits) {
  Beyond beyond(scene);
  const GeometryCounts counts(scene);
  uint64_t instances = instancesOf(scene).size();
  beyond.require(gpu::kInstanceLimit, "the scene", instances, "instances", limits.instances);
  for (const Mesh& mesh : scene.meshes) {
    std::string where = fmt::format("mesh '{}'", mesh.name);
    uint64_t triangles = 0;
    for (const Geometry& geometry : mesh.geometries) triangles += geometry.indices.size() / 3;
    beyond.require(gpu::kTriangleLimit, where, triangles, "triangles", limits.triangles);
    beyond.require(gpu::kGeometryLimit, where, mesh.geometries.size(), "parts", limits.geometries);
  }
  auto requireBytes = [&](const char* what, uint64_t bytes, uint64_t most) {
    beyond.require(gpu::kBufferLimit, fmt::format("the buffer of all {}", what), bytes, "bytes", most);
  };
  requireBytes("vertices", counts.vertices * sizeof(shared::SceneVertex), limits.array_bytes);
  requireBytes("indices", counts.indices * sizeof(uint32_t), limits.array_bytes);
  requireBytes("deformed vertices", counts.bending * slices * sizeof(shared::SceneDeformedVertex), limits.array_bytes);
  requireBytes("transforms", instances * slices * sizeof(shared::SceneTransform), limits.array_bytes);
  if (structures == shader::StructureKind::Own) {
    beyond.require(kTreeLimit, "the scene", counts.indices / 3, "triangles", uint64_t{1} << BVH_LEAF_COUNT);
    requireBytes("triangles of its tree", counts.indices / 3 * sizeof(shared::BvhTriangle), limits.array_bytes);
  }
  beyond.require(gpu::kTextureLimit, "the scene", scene.textures.size(), "textures", limits.textures);
  for (const Texture& texture : scene.textures)
    beyond.require(gpu::kImageLimit, fmt::format("texture '{}'", texture.name),
                   uint64_t(std::max(texture.width, texture.height)), "pixels a side", limits.image_side);
  beyond.finish();
}

// Lower bound for the nodes of the runtime's own trees: four triangles per leaf, four children per node.
uint64_t unposedBytes(const Scene& scene, shader::StructureKind structures) {
  const GeometryCounts counts(scene);
  const uint64_t triangles = structures == shader::StructureKind::Own ? counts.indices / 3 : 0;
  return counts.vertices * sizeof(shared::SceneVertex) + (counts.tangents + counts.indices) * sizeof(uint32_t) +
         textureBytes(scene) + triangles * sizeof(shared::BvhTriangle) + triangles / 12 * sizeof(shared::BvhNode);
}

uint64_t posedBytes(const Scene& scene, uint32_t slices) {
  return slices * (GeometryCounts(scene).bending * sizeof(shared::SceneDeformedVertex) +
                   instancesOf(scene).size() * sizeof(shared::SceneTransform));
}

}  // namespace strobe::world
