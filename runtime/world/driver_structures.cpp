// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <utility>

#include "world/structures.h"

namespace strobe::world {

namespace {

// True if the transform has an inverse, as Vulkan requires of instances.
bool isInvertible(const shared::SceneTransform& transform) {
  const dvec3 x(transform.row_x), y(transform.row_y), z(transform.row_z);
  return glm::dot(x, glm::cross(y, z)) != 0;
}

class DriverStructures : public Structures {
 public:
  DriverStructures(const gpu::Device& device, const scene::Scene& scene, SceneMeshes& meshes, BentInstances& bent,
                   uint32_t slices)
      : device_(device),
        instances_(scene::instancesOf(scene)),
        bent_(bent),
        slices_(slices),
        bottom_levels_(meshes.bottomLevels()) {
    const std::vector<gpu::MeshGeometry> triangles = meshes.triangles();
    for (const scene::Mesh& mesh : scene.meshes)
      flags_.push_back(isOneSided(scene, mesh) ? 0 : VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR);
    for (uint32_t level = 0; level <= levelOf(slices - 1); ++level)
      top_levels_.emplace_back(device, fmt::format("scene.top_level.{}", level), uint32_t(instances_.size()));
    for (uint32_t level = 0; level < top_levels_.size(); ++level)
      for (size_t item = 0; item < bent.items().size(); ++item) addBent(triangles, level, item);
  }

  VkDescriptorSetLayoutBinding binding(uint32_t number) const override {
    return {number, VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR, slices_, VK_SHADER_STAGE_ALL, nullptr};
  }

  void write(const gpu::DescriptorSet& set, uint32_t number) const override {
    std::vector<VkAccelerationStructureKHR> structures;
    for (uint32_t slice = 0; slice < slices_; ++slice) structures.push_back(top_levels_[levelOf(slice)].handle());
    set.write(number, structures);
  }

  void pose(gpu::Staging& staging, uint32_t level, const std::vector<shared::SceneTransform>& transforms,
            const std::vector<bool>& moves) override {
    std::vector<VkAccelerationStructureInstanceKHR> posed(instances_.size());
    for (size_t i = 0; i < instances_.size(); ++i) {
      VkAccelerationStructureInstanceKHR instance{};
      static_assert(sizeof instance.transform == sizeof transforms[0]);
      std::memcpy(&instance.transform, &transforms[i], sizeof instance.transform);
      instance.mask = moves[i] ? RAYS_TO_ALL : RAYS_TO_ALL & ~RAYS_TO_MOVING;
      instance.flags = flags_[size_t(instances_[i].mesh)];
      const gpu::Acceleration& mesh = bottom_levels_[size_t(instances_[i].mesh)];
      instance.accelerationStructureReference = mesh.handle() && isInvertible(transforms[i]) ? mesh.address() : 0;
      posed[i] = instance;
    }
    for (size_t item = 0; item < bent_.items().size(); ++item)
      posed[bent_.items()[item].instance].accelerationStructureReference = bentAt(level, item).structure.address();
    staging.write(top_levels_[level].instances(), 0, posed.data(), posed.size());
  }

  // Levels are independent, so a device may build them in parallel.
  void recordBuild(VkCommandBuffer commands, uint32_t first_level, uint32_t count) override {
    bool any = false;
    for (uint32_t level = first_level; level < first_level + count; ++level) any |= recordBents(commands, level);
    if (any) gpu::recordBuilt(device_, commands);
    const std::span<const gpu::TopLevel> built(&top_levels_.at(first_level), count);
    gpu::TopLevel::recordBuilds(commands, built, uint32_t(instances_.size()));
    gpu::recordBuilt(device_, commands);
  }

 private:
  // Records the builds of changed deformed instances; returns true if there are any.
  bool recordBents(VkCommandBuffer commands, uint32_t level) {
    bool any = false;
    for (size_t item = 0; item < bent_.items().size(); ++item) {
      Bent& bent = bentAt(level, item);
      const uint64_t version = bent_.version(sliceOf(level), item);
      if (std::exchange(bent.version, version) == version || !bent.structure.handle()) continue;
      bent.structure.recordBuild(commands);
      any = true;
    }
    return any;
  }

  // A deformed instance at one level.
  struct Bent {
    gpu::BottomLevel structure;  // empty without triangles
    uint64_t version = 0;        // of the vertices at the last build
  };
  Bent& bentAt(uint32_t level, size_t item) { return bents_[level * bent_.items().size() + item]; }

  void addBent(const std::vector<gpu::MeshGeometry>& meshes, uint32_t level, size_t item) {
    const size_t mesh = size_t(instances_[bent_.items()[item].instance].mesh);
    std::vector<gpu::TriangleGeometry> geometries = meshes[mesh].geometries;
    VkDeviceAddress at = bent_.address(sliceOf(level), item);
    uint64_t triangles = 0;
    for (gpu::TriangleGeometry& geometry : geometries) {
      geometry.vertices = at;
      geometry.vertex_stride = sizeof(shared::SceneDeformedVertex);
      at += VkDeviceAddress(geometry.vertex_count) * geometry.vertex_stride;
      triangles += geometry.triangle_count;
    }
    const std::string name = fmt::format("{}.bent.{}", meshes[mesh].name, level);
    bents_.push_back({triangles ? gpu::BottomLevel(device_, name, geometries) : gpu::BottomLevel(), 0});
  }

  const gpu::Device& device_;
  std::vector<scene::Instance> instances_;
  BentInstances& bent_;
  uint32_t slices_;
  std::vector<VkGeometryInstanceFlagsKHR> flags_;        // by mesh, for its instances
  const std::vector<gpu::Acceleration>& bottom_levels_;  // by mesh
  std::vector<gpu::TopLevel> top_levels_;
  std::vector<Bent> bents_;  // by level, then item
};

}  // namespace

bool isOneSided(const scene::Scene& scene, const scene::Mesh& mesh) {
  return std::none_of(mesh.geometries.begin(), mesh.geometries.end(), [&](const scene::Geometry& geometry) {
    return scene.materials[size_t(geometry.material)].double_sided && !geometry.indices.empty();
  });
}

std::unique_ptr<Structures> makeDriverStructures(const gpu::Device& device, const scene::Scene& scene,
                                                 SceneMeshes& meshes, BentInstances& bent, uint32_t slices) {
  return std::make_unique<DriverStructures>(device, scene, meshes, bent, slices);
}

}  // namespace strobe::world
