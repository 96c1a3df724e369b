// SPDX-License-Identifier: MIT
// Acceleration structures of the driver. One bottom level per mesh, one per pose of a deformed mesh; top levels are
// rebuilt for every pose of a frame.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gpu/resources.h"

namespace strobe::gpu {

// An indexed triangle list in device memory, as input of a bottom-level build.
struct TriangleGeometry {
  VkDeviceAddress vertices = 0;  // address of the first vertex; a vertex begins with its position
  uint32_t vertex_count = 0;
  uint32_t vertex_stride = 0;
  VkDeviceAddress indices = 0;  // uint32, relative to the first vertex
  uint32_t triangle_count = 0;
  bool opaque = true;  // false: shaders may reject hits
};

// An acceleration structure of the driver, with the memory that stores it and its device address.
class Acceleration {
 public:
  Acceleration() = default;
  VkAccelerationStructureKHR handle() const { return structure_.get(); }
  VkDeviceAddress address() const { return address_; }
  VkDeviceSize bytes() const { return storage_.size(); }

 private:
  friend Acceleration makeAcceleration(const Device&, const std::string&, VkAccelerationStructureTypeKHR, VkDeviceSize);
  Buffer storage_;
  Owned<VkAccelerationStructureKHR> structure_;
  VkDeviceAddress address_ = 0;
};

// A bottom level over changing vertices, rebuilt in place by `recordBuild`.
class BottomLevel {
 public:
  BottomLevel() = default;
  // Requires at least one triangle in total. `compactable`: the structure can be copied to a smaller one.
  BottomLevel(const Device& device, const std::string& name, const std::vector<TriangleGeometry>& geometries,
              bool compactable = false);
  VkAccelerationStructureKHR handle() const { return structure_.handle(); }
  VkDeviceAddress address() const { return structure_.address(); }
  // Records the build without a barrier. The caller records a barrier before tracing the structure or building over it.
  void recordBuild(VkCommandBuffer commands) const;
  // Bytes of the structure and of the memory for its build.
  VkDeviceSize bytes() const { return structure_.bytes() + scratch_.size(); }

 private:
  VkAccelerationStructureBuildGeometryInfoKHR buildInfo() const;
  const Device* device_ = nullptr;
  std::vector<VkAccelerationStructureGeometryKHR> geometries_;
  std::vector<VkAccelerationStructureBuildRangeInfoKHR> ranges_;
  VkBuildAccelerationStructureFlagsKHR flags_ = 0;
  Acceleration structure_;
  Buffer scratch_;
};

// Records a barrier between builds or copies of structures and later reads.
void recordBuilt(const Device& device, VkCommandBuffer commands);

// A mesh to build a structure for.
struct MeshGeometry {
  std::string name;
  std::vector<TriangleGeometry> geometries;
};

// Builds and compacts the structures of many meshes in few submissions, and waits. The structure of a mesh without
// triangles is empty.
std::vector<Acceleration> buildBottomLevels(const Device& device, const std::vector<MeshGeometry>& meshes);

// A top level over `capacity` instances, rebuilt in place by `recordBuild`.
class TopLevel {
 public:
  TopLevel() = default;
  TopLevel(const Device& device, const std::string& name, uint32_t capacity);
  VkAccelerationStructureKHR handle() const { return structure_.handle(); }
  // Input of the next build: an array of VkAccelerationStructureInstanceKHR.
  const Buffer& instances() const { return instances_; }
  // Records the builds of `levels` (at least one), each over its first `count` instances, at most its capacity. Records
  // no barrier: the caller records one before tracing.
  static void recordBuilds(VkCommandBuffer commands, std::span<const TopLevel> levels, uint32_t count);

 private:
  VkAccelerationStructureBuildGeometryInfoKHR buildInfo(VkAccelerationStructureGeometryKHR& geometry) const;
  const Device* device_ = nullptr;
  Acceleration structure_;
  Buffer instances_, scratch_;
};

}  // namespace strobe::gpu
