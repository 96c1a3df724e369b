// SPDX-License-Identifier: MIT
// Acceleration structures: one bottom level per mesh, and per pose of what bends; top levels rebuilt for every pose
// that a frame needs.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gpu/resources.h"

namespace strobe::gpu {

struct TriangleGeometry {
  VkDeviceAddress vertices = 0;  // address of the first vertex; the position stands first in a vertex
  uint32_t vertex_count = 0;
  uint32_t vertex_stride = 0;
  VkDeviceAddress indices = 0;  // uint32, relative to the first vertex
  uint32_t triangle_count = 0;
  bool opaque = true;  // false: hits are offered to the shader, which may refuse them
};

class Acceleration {
 public:
  Acceleration() = default;
  VkAccelerationStructureKHR handle() const { return structure_.get(); }
  VkDeviceAddress address() const { return address_; }

 private:
  friend Acceleration makeAcceleration(const Device&, const std::string&, VkAccelerationStructureTypeKHR, VkDeviceSize);
  Buffer storage_;
  Owned<VkAccelerationStructureKHR> structure_;
  VkDeviceAddress address_ = 0;
};

// Builds and waits. At least one triangle in all.
Acceleration buildBottomLevel(const Device& device, const std::string& name,
                              const std::vector<TriangleGeometry>& geometries);

// A bottom level over vertices that change, rebuilt in place by `recordBuild`.
class BottomLevel {
 public:
  BottomLevel() = default;
  // At least one triangle in all.
  BottomLevel(const Device& device, const std::string& name, const std::vector<TriangleGeometry>& geometries);
  VkAccelerationStructureKHR handle() const { return structure_.handle(); }
  VkDeviceAddress address() const { return structure_.address(); }
  // Records the build alone: whoever traces it, or builds over it, waits for that.
  void recordBuild(VkCommandBuffer commands) const;
  // The structure, once it is built for good.
  Acceleration finish() && { return std::move(structure_); }

 private:
  VkAccelerationStructureBuildGeometryInfoKHR buildInfo() const;
  const Device* device_ = nullptr;
  std::vector<VkAccelerationStructureGeometryKHR> geometries_;
  std::vector<VkAccelerationStructureBuildRangeInfoKHR> ranges_;
  Acceleration structure_;
  Buffer scratch_;
};

// A top level over `capacity` instances, rebuilt in place by `recordBuild`.
class TopLevel {
 public:
  TopLevel() = default;
  TopLevel(const Device& device, const std::string& name, uint32_t capacity);
  VkAccelerationStructureKHR handle() const { return structure_.handle(); }
  // What the next build reads: a VkAccelerationStructureInstanceKHR each.
  const Buffer& instances() const { return instances_; }
  // Records the builds of at least one at once, each over its first `count` instances, for which it has room. Whoever
  // traces them waits for that.
  static void recordBuilds(VkCommandBuffer commands, std::span<const TopLevel> levels, uint32_t count);

 private:
  VkAccelerationStructureBuildGeometryInfoKHR buildInfo(VkAccelerationStructureGeometryKHR& geometry) const;
  const Device* device_ = nullptr;
  Acceleration structure_;
  Buffer instances_, scratch_;
};

}  // namespace strobe::gpu
