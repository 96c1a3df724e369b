// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include "world/structures.h"

namespace strobe::world {

namespace {

class DriverStructures : public Structures {
 public:
  DriverStructures(const gpu::Device& device, const scene::Scene& scene,
                   const std::vector<std::vector<gpu::TriangleGeometry>>& meshes, uint32_t slices)
      : device_(device), instances_(scene::instancesOf(scene)), slices_(slices) {
    for (size_t m = 0; m < meshes.size(); ++m) {
      uint64_t triangles = 0;
      for (const gpu::TriangleGeometry& geometry : meshes[m]) triangles += geometry.triangle_count;
      bottom_levels_.push_back(triangles
                                   ? gpu::buildBottomLevel(device, "scene.mesh." + scene.meshes[m].name, meshes[m])
                                   : gpu::Acceleration());
    }
    for (const scene::Mesh& mesh : scene.meshes)
      flags_.push_back(isOneSided(scene, mesh) ? 0 : VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR);
    for (uint32_t level = 0; level <= levelOf(slices - 1); ++level)
      top_levels_.emplace_back(device, fmt::format("scene.top_level.{}", level), uint32_t(instances_.size()));
  }

  VkDescriptorSetLayoutBinding binding(uint32_t number) const override {
    return {number, VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR, slices_, VK_SHADER_STAGE_ALL, nullptr};
  }

  void write(VkDescriptorSet set, uint32_t number) const override {
    std::vector<VkAccelerationStructureKHR> structures;
    for (uint32_t slice = 0; slice < slices_; ++slice) structures.push_back(top_levels_[levelOf(slice)].handle());
    VkWriteDescriptorSetAccelerationStructureKHR info{
        VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR};
    info.accelerationStructureCount = slices_;
    info.pAccelerationStructures = structures.data();
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET, &info};
    write.dstSet = set;
    write.dstBinding = number;
    write.descriptorType = VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR;
    write.descriptorCount = slices_;
    device_.vk().UpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
  }

  void pose(uint32_t level, const shared::SceneTransform* transforms, const std::vector<bool>& moves) override {
    VkAccelerationStructureInstanceKHR* posed = top_levels_[level].instances();
    for (size_t i = 0; i < instances_.size(); ++i) {
      VkAccelerationStructureInstanceKHR instance{};
      static_assert(sizeof instance.transform == sizeof *transforms);
      std::memcpy(&instance.transform, &transforms[i], sizeof instance.transform);
      instance.mask = moves[i] ? RAYS_TO_ALL : RAYS_TO_ALL & ~RAYS_TO_MOVING;
      instance.flags = flags_[size_t(instances_[i].mesh)];
      const gpu::Acceleration& mesh = bottom_levels_[size_t(instances_[i].mesh)];
      instance.accelerationStructureReference = mesh.handle() ? mesh.address() : 0;
      posed[i] = instance;
    }
  }

  void recordBuild(VkCommandBuffer commands, uint32_t level) const override {
    top_levels_[level].recordBuild(commands, uint32_t(instances_.size()));
  }

 private:
  const gpu::Device& device_;
  std::vector<scene::Instance> instances_;
  uint32_t slices_;
  std::vector<VkGeometryInstanceFlagsKHR> flags_;  // of instances of each mesh
  std::vector<gpu::Acceleration> bottom_levels_;   // of each mesh, empty where it has no triangles
  std::vector<gpu::TopLevel> top_levels_;
};

}  // namespace

bool isOneSided(const scene::Scene& scene, const scene::Mesh& mesh) {
  return std::none_of(mesh.geometries.begin(), mesh.geometries.end(), [&](const scene::Geometry& geometry) {
    return scene.materials[size_t(geometry.material)].double_sided && !geometry.indices.empty();
  });
}

std::unique_ptr<Structures> makeDriverStructures(const gpu::Device& device, const scene::Scene& scene,
                                                 const std::vector<std::vector<gpu::TriangleGeometry>>& meshes,
                                                 uint32_t slices) {
  return std::make_unique<DriverStructures>(device, scene, meshes, slices);
}

}  // namespace strobe::world
