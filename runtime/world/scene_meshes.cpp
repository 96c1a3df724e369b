// SPDX-License-Identifier: MIT
#include "world/scene_meshes.h"

#include <glm/gtc/packing.hpp>

#include "scene/bend.h"
#include "world/limits.h"
#include "world/structures.h"
#include "world/tangent.h"

namespace strobe::world {

using namespace scene;
using namespace shared;

SceneMeshes::SceneMeshes(const gpu::Device& device, const Scene& scene) : device_(device), scene_(scene) {
  VkBufferUsageFlags usage = gpu::kReadByAddress;
  if (device.info().has("accelerationStructure"))
    usage |= VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR;
  numberGeometries();
  vertices_ = uploadVertices(usage);
  tangents_ = uploadTangents();
  indices_ = uploadIndices(usage | VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
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

gpu::Buffer SceneMeshes::uploadVertices(VkBufferUsageFlags usage) const {
  gpu::Upload upload(device_, "scene.vertices", vertex_count_ * sizeof(SceneVertex), usage);
  for (const std::vector<const Geometry*>& geometries : {geometriesOf(scene_), bendingGeometriesOf(scene_)})
    for (const Geometry* geometry : geometries)
      upload.append<SceneVertex>(geometry->vertices.size(),
                                 [&](size_t i) { return deviceVertex(geometry->vertices[i]); });
  return upload.finish();
}

gpu::Buffer SceneMeshes::uploadTangents() const {
  gpu::Upload upload(device_, "scene.tangents", tangent_count_ * sizeof(uint32_t), gpu::kReadByAddress);
  for (const Geometry* geometry : geometriesOf(scene_))
    upload.append<uint32_t>(geometry->tangents.size(), [&](size_t i) { return packedTangent(geometry->tangents[i]); });
  return upload.finish();
}

gpu::Buffer SceneMeshes::uploadIndices(VkBufferUsageFlags usage) const {
  gpu::Upload upload(device_, "scene.indices", index_count_ * sizeof(uint32_t), usage);
  for (const Geometry* geometry : geometriesOf(scene_))
    upload.append<uint32_t>(geometry->indices.size(), [&](size_t i) { return geometry->indices[i]; });
  return upload.finish();
}

std::vector<std::vector<gpu::TriangleGeometry>> SceneMeshes::triangles() const {
  std::vector<std::vector<gpu::TriangleGeometry>> meshes;
  for (size_t m = 0; m < scene_.meshes.size(); ++m) {
    const Mesh& mesh = scene_.meshes[m];
    meshes.emplace_back();
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
      meshes.back().push_back(d);
    }
  }
  return meshes;
}

const std::vector<gpu::Acceleration>& SceneMeshes::bottomLevels() {
  if (!bottom_levels_.empty()) return bottom_levels_;
  std::vector<gpu::Acceleration> levels;
  for (const std::vector<gpu::TriangleGeometry>& mesh : triangles()) {
    uint64_t count = 0;
    for (const gpu::TriangleGeometry& geometry : mesh) count += geometry.triangle_count;
    const std::string name = "scene.mesh." + scene_.meshes[levels.size()].name;
    levels.push_back(count ? gpu::buildBottomLevel(device_, name, mesh) : gpu::Acceleration());
  }
  bottom_levels_ = std::move(levels);
  return bottom_levels_;
}

const MeshTrees& SceneMeshes::trees() {
  if (trees_) return *trees_;
  auto trees = std::make_unique<MeshTrees>(buildMeshTrees(scene_));
  if (trees->nodes.size() > BVH_MOST_NODES)
    throw Error(kTreeLimit.text(
        fmt::format("{}: its tree has {} nodes of at most {}", scene_.name, trees->nodes.size(), BVH_MOST_NODES)));
  const std::vector<BvhTriangle>& triangles = trees->triangles;
  tree_triangles_ =
      gpu::uploadBuffer(device_, "scene.bvh.triangles", triangles.data(), triangles.size() * sizeof(BvhTriangle),
                        gpu::kReadByAddress | VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  trees->triangles = {};
  trees_ = std::move(trees);
  return *trees_;
}

}  // namespace strobe::world
