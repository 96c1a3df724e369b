// SPDX-License-Identifier: MIT
#include "world/scene_meshes.h"

#include <glm/gtc/packing.hpp>

#include "scene/bend.h"
#include "world/structures.h"
#include "world/tangent.h"

namespace strobe::world {

using namespace scene;
using namespace shared;

SceneMeshes::SceneMeshes(const gpu::Device& device, const Scene& scene, gpu::Uploads& uploads)
    : device_(device), scene_(scene) {
  numberGeometries();
  upload(uploads);
}

void SceneMeshes::numberGeometries() {
  for (const Mesh& mesh : scene_.meshes) {
    first_geometry_.push_back(uint32_t(geometries_.size()));
    bounds_.push_back(vertexBounds(mesh));
    for (const Geometry& source : mesh.geometries) {
      geometries_.push_back({uint32_t(index_count_), uint32_t(vertex_count_), uint32_t(source.indices.size() / 3),
                             uint32_t(source.material),
                             source.tangents.empty() ? NO_TANGENTS : uint32_t(tangent_count_)});
      tangent_count_ += source.tangents.size();
      vertex_count_ += source.vertices.size();
      index_count_ += source.indices.size();
    }
  }
  first_bending_vertex_ = uint32_t(vertex_count_);
  numberBending();
}

void SceneMeshes::numberBending() {
  const std::vector<Instance> instances = instancesOf(scene_);
  for (size_t i = 0; i < instances.size(); ++i) {
    if (!bends(scene_, instances[i])) continue;
    Bending bending{uint32_t(i), uint32_t(geometries_.size()), uint32_t(vertex_count_), 0};
    const size_t mesh = size_t(instances[i].mesh), first = first_geometry_[mesh];
    for (size_t g = 0; g < scene_.meshes[mesh].geometries.size(); ++g) {
      SceneGeometry geometry = geometries_[first + g];
      geometry.first_vertex = uint32_t(vertex_count_);
      geometries_.push_back(geometry);
      vertex_count_ += scene_.meshes[mesh].geometries[g].vertices.size();
    }
    bending.vertex_count = uint32_t(vertex_count_) - bending.first_vertex;
    bending_.push_back(bending);
  }
}

// Geometries of all meshes, in order.
static std::vector<const Geometry*> geometriesOf(const Scene& scene) {
  std::vector<const Geometry*> all;
  for (const Mesh& mesh : scene.meshes)
    for (const Geometry& geometry : mesh.geometries) all.push_back(&geometry);
  return all;
}

// Geometries of the deformed instances, in order.
static std::vector<const Geometry*> bendingGeometriesOf(const Scene& scene) {
  std::vector<const Geometry*> all;
  for (const Instance& instance : instancesOf(scene))
    for (const Geometry& geometry : scene.meshes[size_t(instance.mesh)].geometries)
      if (bends(scene, instance)) all.push_back(&geometry);
  return all;
}

static SceneVertex deviceVertex(const Vertex& v) {
  return {v.position, v.normal, v.uv0, v.uv1, glm::packUnorm4x8(v.color)};
}

void SceneMeshes::upload(gpu::Uploads& uploads) {
  VkBufferUsageFlags usage = gpu::kReadByAddress;
  if (device_.info().has("accelerationStructure"))
    usage |= VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR;
  auto array = [&](const char* name, size_t bytes, VkBufferUsageFlags uses) {
    return gpu::Buffer(device_, name, bytes, uses, gpu::Buffer::Memory::Device);
  };
  vertices_ = array("scene.vertices", vertex_count_ * sizeof(SceneVertex), usage);
  tangents_ = array("scene.tangents", tangent_count_ * sizeof(uint32_t), gpu::kReadByAddress);
  indices_ = array("scene.indices", index_count_ * sizeof(uint32_t), usage | VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  const std::vector<const Geometry*> meshes = geometriesOf(scene_), bending = bendingGeometriesOf(scene_);
  size_t vertex = 0, tangent = 0, index = 0;
  for (const auto& geometries : {meshes, bending})
    for (const Geometry* geometry : geometries) {
      const std::vector<Vertex>& vertices = geometry->vertices;
      uploads.fill<SceneVertex>(vertices_, vertex, vertices.size(),
                                [&](size_t i) { return deviceVertex(vertices[i]); });
      vertex += vertices.size();
    }
  for (const Geometry* geometry : meshes) {
    const auto& tangents = geometry->tangents;
    uploads.fill<uint32_t>(tangents_, tangent, tangents.size(), [&](size_t i) { return packedTangent(tangents[i]); });
    tangent += tangents.size();
  }
  for (const Geometry* geometry : meshes) {
    uploads.fill<uint32_t>(indices_, index, geometry->indices.size(), [&](size_t i) { return geometry->indices[i]; });
    index += geometry->indices.size();
  }
}

std::vector<gpu::MeshGeometry> SceneMeshes::triangles() const {
  std::vector<gpu::MeshGeometry> meshes;
  for (size_t m = 0; m < scene_.meshes.size(); ++m) {
    const Mesh& mesh = scene_.meshes[m];
    meshes.push_back({"scene.mesh." + mesh.name, {}});
    for (size_t g = 0; g < mesh.geometries.size(); ++g) {
      const SceneGeometry& geometry = geometries_[first_geometry_[m] + g];
      gpu::TriangleGeometry d;
      d.vertices = vertices_.address() + geometry.first_vertex * sizeof(SceneVertex);
      d.vertex_count = uint32_t(mesh.geometries[g].vertices.size());
      d.vertex_stride = sizeof(SceneVertex);
      d.indices = indices_.address() + geometry.first_index * sizeof(uint32_t);
      d.triangle_count = geometry.triangle_count;
      const scene::Material& material = scene_.materials[geometry.material];
      d.opaque =
          material.alpha == scene::Material::Alpha::Opaque && (material.double_sided || isOneSided(scene_, mesh));
      meshes.back().geometries.push_back(d);
    }
  }
  return meshes;
}

const std::vector<gpu::Acceleration>& SceneMeshes::bottomLevels() {
  if (bottom_levels_.empty()) bottom_levels_ = gpu::buildBottomLevels(device_, triangles());
  return bottom_levels_;
}

const MeshTrees& SceneMeshes::trees() {
  if (trees_) return *trees_;
  auto trees = std::make_unique<MeshTrees>(buildMeshTrees(scene_));
  gpu::Uploads uploads(device_);
  tree_triangles_ = uploads.array("scene.bvh.triangles", trees->triangles, gpu::kReadByAddress);
  uploads.finish();
  trees->triangles = {};
  trees_ = std::move(trees);
  return *trees_;
}

}  // namespace strobe::world
