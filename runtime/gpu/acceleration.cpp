// SPDX-License-Identifier: MIT
#include "gpu/acceleration.h"

#include <algorithm>

namespace strobe::gpu {

Acceleration makeAcceleration(const Device& device, const std::string& name, VkAccelerationStructureTypeKHR type,
                              VkDeviceSize size) {
  Acceleration result;
  result.storage_ =
      Buffer(device, name, size,
             VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT,
             Buffer::Memory::Device);
  VkAccelerationStructureCreateInfoKHR info{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR};
  info.buffer = result.storage_.handle();
  info.size = size;
  info.type = type;
  const Dispatch& vk = device.vk();
  result.structure_ = create(device, VK_OBJECT_TYPE_ACCELERATION_STRUCTURE_KHR, vk.CreateAccelerationStructureKHR,
                             vk.DestroyAccelerationStructureKHR, info, "acceleration structure", name);
  VkAccelerationStructureDeviceAddressInfoKHR address{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR};
  address.accelerationStructure = result.handle();
  result.address_ = vk.GetAccelerationStructureDeviceAddressKHR(device.handle(), &address);
  return result;
}

static VkAccelerationStructureBuildGeometryInfoKHR buildInfo(VkAccelerationStructureTypeKHR type,
                                                             const VkAccelerationStructureGeometryKHR* geometries,
                                                             size_t count,
                                                             VkBuildAccelerationStructureFlagsKHR flags = 0) {
  VkAccelerationStructureBuildGeometryInfoKHR info{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR};
  info.type = type;
  info.flags = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR | flags;
  info.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
  info.geometryCount = uint32_t(count);
  info.pGeometries = geometries;
  return info;
}

static VkAccelerationStructureBuildSizesInfoKHR buildSizes(const Device& device,
                                                           const VkAccelerationStructureBuildGeometryInfoKHR& info,
                                                           const std::vector<uint32_t>& counts) {
  VkAccelerationStructureBuildSizesInfoKHR sizes{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR};
  device.vk().GetAccelerationStructureBuildSizesKHR(device.handle(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR,
                                                    &info, counts.data(), &sizes);
  return sizes;
}

static Buffer scratchBuffer(const Device& device, const std::string& name, VkDeviceSize size) {
  return Buffer(device, name + ".scratch", size + device.scratchAlignment(), kReadByAddress, Buffer::Memory::Device);
}

static VkDeviceAddress alignedScratch(const Device& device, const Buffer& scratch) {
  VkDeviceAddress alignment = device.scratchAlignment();
  return (scratch.address() + alignment - 1) / alignment * alignment;
}

static VkAccelerationStructureGeometryKHR described(const TriangleGeometry& source) {
  VkAccelerationStructureGeometryKHR geometry{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR};
  geometry.geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR;
  geometry.flags = source.opaque ? VK_GEOMETRY_OPAQUE_BIT_KHR : VK_GEOMETRY_NO_DUPLICATE_ANY_HIT_INVOCATION_BIT_KHR;
  auto& triangles = geometry.geometry.triangles;
  triangles.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR;
  triangles.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
  triangles.vertexData.deviceAddress = source.vertices;
  triangles.vertexStride = source.vertex_stride;
  triangles.maxVertex = source.vertex_count ? source.vertex_count - 1 : 0;
  triangles.indexType = VK_INDEX_TYPE_UINT32;
  triangles.indexData.deviceAddress = source.indices;
  return geometry;
}

VkAccelerationStructureBuildGeometryInfoKHR BottomLevel::buildInfo() const {
  return gpu::buildInfo(VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, geometries_.data(), geometries_.size(),
                        flags_);
}

BottomLevel::BottomLevel(const Device& device, const std::string& name, const std::vector<TriangleGeometry>& geometries,
                         bool compactable)
    : device_(&device), flags_(compactable ? VK_BUILD_ACCELERATION_STRUCTURE_ALLOW_COMPACTION_BIT_KHR : 0) {
  std::vector<uint32_t> counts;
  for (const TriangleGeometry& source : geometries) {
    geometries_.push_back(described(source));
    VkAccelerationStructureBuildRangeInfoKHR range{};
    range.primitiveCount = source.triangle_count;
    ranges_.push_back(range);
    counts.push_back(source.triangle_count);
  }
  auto info = buildInfo();
  auto sizes = buildSizes(device, info, counts);
  structure_ = makeAcceleration(device, name, info.type, sizes.accelerationStructureSize);
  scratch_ = scratchBuffer(device, name, sizes.buildScratchSize);
}

void BottomLevel::recordBuild(VkCommandBuffer commands) const {
  auto info = buildInfo();
  info.dstAccelerationStructure = structure_.handle();
  info.scratchData.deviceAddress = alignedScratch(*device_, scratch_);
  const VkAccelerationStructureBuildRangeInfoKHR* ranges = ranges_.data();
  device_->vk().CmdBuildAccelerationStructuresKHR(commands, 1, &info, &ranges);
}

void recordBuilt(const Device& device, VkCommandBuffer commands) {
  recordBarrier(
      device, commands,
      {VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR, VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR},
      {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR});
}

// Builds the structures and returns the size of each one after compaction.
static std::vector<VkDeviceSize> buildTogether(const Device& device, const std::vector<BottomLevel>& levels) {
  const Dispatch& vk = device.vk();
  const uint32_t count = uint32_t(levels.size());
  VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_ACCELERATION_STRUCTURE_COMPACTED_SIZE_KHR;
  info.queryCount = count;
  const Owned<VkQueryPool> pool = create(device, VK_OBJECT_TYPE_QUERY_POOL, vk.CreateQueryPool, vk.DestroyQueryPool,
                                         info, "query pool", "compacted sizes");
  std::vector<VkAccelerationStructureKHR> handles;
  for (const BottomLevel& level : levels) handles.push_back(level.handle());
  device.submit([&](VkCommandBuffer commands) {
    vk.CmdResetQueryPool(commands, pool.get(), 0, count);
    for (const BottomLevel& level : levels) level.recordBuild(commands);
    recordBuilt(device, commands);
    vk.CmdWriteAccelerationStructuresPropertiesKHR(commands, count, handles.data(), info.queryType, pool.get(), 0);
  });
  std::vector<VkDeviceSize> sizes(count);
  check(vk.GetQueryPoolResults(device.handle(), pool.get(), 0, count, count * sizeof(VkDeviceSize), sizes.data(),
                               sizeof(VkDeviceSize), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "reading the sizes of acceleration structures");
  return sizes;
}

// Builds the meshes from `first` on until they take `kMost` bytes, and returns the mesh after them.
static size_t buildSome(const Device& device, const std::vector<MeshGeometry>& meshes, size_t first,
                        std::vector<Acceleration>& built) {
  constexpr VkDeviceSize kMost = VkDeviceSize{128} << 20;
  std::vector<BottomLevel> levels;
  std::vector<size_t> of;  // mesh of each level
  VkDeviceSize bytes = 0;
  size_t mesh = first;
  for (; mesh < meshes.size() && bytes < kMost; ++mesh) {
    const auto& [name, geometries] = meshes[mesh];
    if (std::all_of(geometries.begin(), geometries.end(), [](const auto& one) { return one.triangle_count == 0; }))
      continue;
    levels.emplace_back(device, name, geometries, true);
    of.push_back(mesh);
    bytes += levels.back().bytes();
  }
  if (levels.empty()) return mesh;
  const std::vector<VkDeviceSize> sizes = buildTogether(device, levels);
  for (size_t i = 0; i < of.size(); ++i)
    built[of[i]] =
        makeAcceleration(device, meshes[of[i]].name, VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, sizes[i]);
  device.submit([&](VkCommandBuffer commands) {
    for (size_t i = 0; i < of.size(); ++i) {
      VkCopyAccelerationStructureInfoKHR copy{VK_STRUCTURE_TYPE_COPY_ACCELERATION_STRUCTURE_INFO_KHR};
      copy.src = levels[i].handle();
      copy.dst = built[of[i]].handle();
      copy.mode = VK_COPY_ACCELERATION_STRUCTURE_MODE_COMPACT_KHR;
      device.vk().CmdCopyAccelerationStructureKHR(commands, &copy);
    }
    recordBuilt(device, commands);
  });
  return mesh;
}

std::vector<Acceleration> buildBottomLevels(const Device& device, const std::vector<MeshGeometry>& meshes) {
  std::vector<Acceleration> built(meshes.size());
  for (size_t mesh = 0; mesh < meshes.size();) mesh = buildSome(device, meshes, mesh, built);
  return built;
}

VkAccelerationStructureBuildGeometryInfoKHR TopLevel::buildInfo(VkAccelerationStructureGeometryKHR& geometry) const {
  geometry = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR};
  geometry.geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR;
  geometry.geometry.instances.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR;
  geometry.geometry.instances.data.deviceAddress = instances_.address();
  return gpu::buildInfo(VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR, &geometry, 1);
}

TopLevel::TopLevel(const Device& device, const std::string& name, uint32_t capacity) : device_(&device) {
  size_t bytes = std::max(1u, capacity) * sizeof(VkAccelerationStructureInstanceKHR);
  instances_ = Buffer(
      device, name + ".instances", bytes,
      VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT,
      Buffer::Memory::Device);
  VkAccelerationStructureGeometryKHR geometry;
  auto sizes = buildSizes(device, buildInfo(geometry), {std::max(1u, capacity)});
  structure_ =
      makeAcceleration(device, name, VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR, sizes.accelerationStructureSize);
  scratch_ = scratchBuffer(device, name, sizes.buildScratchSize);
}

void TopLevel::recordBuilds(VkCommandBuffer commands, std::span<const TopLevel> levels, uint32_t count) {
  VkAccelerationStructureBuildRangeInfoKHR range{};
  range.primitiveCount = count;
  std::vector<VkAccelerationStructureGeometryKHR> geometries(levels.size());
  std::vector<VkAccelerationStructureBuildGeometryInfoKHR> infos;
  for (size_t i = 0; i < levels.size(); ++i) {
    infos.push_back(levels[i].buildInfo(geometries[i]));
    infos.back().dstAccelerationStructure = levels[i].structure_.handle();
    infos.back().scratchData.deviceAddress = alignedScratch(*levels[i].device_, levels[i].scratch_);
  }
  const std::vector<const VkAccelerationStructureBuildRangeInfoKHR*> ranges(levels.size(), &range);
  levels[0].device_->vk().CmdBuildAccelerationStructuresKHR(commands, uint32_t(infos.size()), infos.data(),
                                                            ranges.data());
}

}  // namespace strobe::gpu
