// SPDX-License-Identifier: MIT
#include "world/bent_instances.h"

#include "scene/bend.h"
#include "world/tangent.h"

namespace strobe::world {

using shared::SceneDeformedVertex;

BentInstances::BentInstances(const gpu::Device& device, const scene::Scene& scene, const SceneMeshes& meshes,
                             uint32_t slices)
    : scene_(scene),
      instances_(scene::instancesOf(scene)),
      items_(meshes.bending()),
      first_vertex_(meshes.firstBendingVertex()) {
  for (const SceneMeshes::Bending& item : items_) vertex_count_ += item.vertex_count;
  posed_.resize(slices * items_.size());
  bent_.resize(items_.size());
  bent_at_.resize(items_.size());
  VkBufferUsageFlags usage = gpu::kReadByAddress;
  if (device.info().has("accelerationStructure"))
    usage |= VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR;
  buffer_ = gpu::Buffer(device, "scene.bent_vertices", size_t(slices) * vertex_count_ * sizeof(SceneDeformedVertex),
                        usage, gpu::Buffer::Memory::Device);
}

size_t BentInstances::firstVertex(uint32_t slice, size_t item) const {
  return size_t(slice) * vertex_count_ + (items_[item].first_vertex - first_vertex_);
}

VkDeviceAddress BentInstances::address(uint32_t slice, size_t item) const {
  return buffer_.address() + firstVertex(slice, item) * sizeof(SceneDeformedVertex);
}

void BentInstances::pose(gpu::Staging& staging, uint32_t slice, const scene::Pose& pose, const dvec3& origin) {
  for (size_t i = 0; i < items_.size(); ++i) {
    const dmat4& world = pose.world_from_instance[items_[i].instance];
    const scene::Bend& bend = pose.bends[items_[i].instance];
    // Vertices with joints are in world axes, possibly with one axis mirrored, so the matrix is its own inverse.
    const dvec3 shift = bend.joints.empty() ? dvec3(0) : dmat3(world) * origin;
    Posed& posed = posed_[slice * items_.size() + i];
    posed.world = glm::translate(world, shift);
    if (posed.version > 0 && posed.bend == bend && posed.shift == shift) continue;
    posed.bend = bend, posed.shift = shift;
    this->bend(i, posed);
    staging.write(buffer_, firstVertex(slice, i), bent_[i].data(), bent_[i].size());
    bent_at_[i] = slice;
    ++posed.version;
  }
}

void BentInstances::bend(size_t item, Posed& posed) {
  std::vector<SceneDeformedVertex>& bent = bent_[item];
  bent.clear();
  posed.bounds = {};
  dvec3 sum(0);  // not finite if a position is not finite
  for (const scene::BentVertex& vertex : scene::bentVertices(scene_, instances_[items_[item].instance], posed.bend)) {
    bent.push_back({vec3(vertex.position - posed.shift), vec3(vertex.normal), packedTangent(vec4(vertex.tangent))});
    posed.bounds.add(dvec3(bent.back().position));
    sum += vertex.position;
  }
  if (!std::isfinite(sum.x + sum.y + sum.z)) posed.bounds.high = dvec3(HUGE_VAL);
}

const std::vector<SceneDeformedVertex>& BentInstances::vertices(uint32_t slice, size_t item) {
  if (bent_at_[item] != slice) bend(item, posed_[slice * items_.size() + item]);
  bent_at_[item] = slice;
  return bent_[item];
}

}  // namespace strobe::world
