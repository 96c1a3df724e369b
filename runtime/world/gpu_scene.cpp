// SPDX-License-Identifier: MIT
#include "world/gpu_scene.h"

#include <algorithm>
#include <cmath>

#include "scene/limits.h"

namespace strobe::world {

using gpu::Buffer;
using namespace scene;
using namespace shared;
using shader::StructureKind;

// Layout of SceneArrays in shaders/shared/bindings.glsl.
struct SceneAddresses {
  VkDeviceAddress vertices, tangents, indices, geometries, instances, draws, materials, lights, transforms, cameras,
      bent;
  uint32_t first_deformed, deformed_count;
};

GpuScene::GpuScene(const gpu::Device& device, const Scene& scene, uint32_t slices,
                   const std::shared_ptr<UnposedScene>& unposed, StructureKind structures)
    : device_(device),
      scene_(scene),
      slices_(std::max(slices, SLICE_SAMPLE)),
      instances_(instancesOf(scene)),
      light_nodes_(lightsOf(scene)),
      unposed_(unposed),
      bent_(device, scene, unposed->meshes, slices_),
      bent_items_(instances_.size(), -1) {
  for (size_t i = 0; i < bent_.items().size(); ++i) bent_items_[bent_.items()[i].instance] = int(i);
  gpu::Uploads uploads(device);
  uploadGeometry(scene, uploads);
  SceneMeshes& meshes = unposed->meshes;
  structures_ = structures == StructureKind::Own
                    ? makeOwnStructures(device, scene, meshes.trees(), meshes.treeTriangles(), bent_, slices_, uploads)
                    : makeDriverStructures(device, scene, meshes, bent_, slices_);
  auto array = [&](const char* name, size_t bytes, VkBufferUsageFlags usage) {
    return Buffer(device_, name, bytes, usage, Buffer::Memory::Device);
  };
  frame_ = array("frame", sizeof(FrameData), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  lights_ = array("scene.lights", slices_ * light_nodes_.size() * sizeof(SceneLight), gpu::kReadByAddress);
  transforms_ = array("scene.transforms", slices_ * instances_.size() * sizeof(SceneTransform), gpu::kReadByAddress);
  cameras_ = array("scene.cameras", slices_ * sizeof(SceneCamera), gpu::kReadByAddress);
  const SceneAddresses addresses{meshes.vertices().address(),
                                 meshes.tangents().address(),
                                 meshes.indices().address(),
                                 geometry_buffer_.address(),
                                 instance_buffer_.address(),
                                 draw_buffer_.address(),
                                 unposed->surfaces.materials().address(),
                                 lights_.address(),
                                 transforms_.address(),
                                 cameras_.address(),
                                 bent_.address(),
                                 meshes.firstBendingVertex(),
                                 bent_.vertexCount()};
  addresses_ = uploads.array("scene.arrays", std::vector{addresses}, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  uploads.finish();
  makeSet();
}

void GpuScene::uploadGeometry(const Scene& scene, gpu::Uploads& uploads) {
  const SceneMeshes& meshes = unposed_->meshes;
  const std::vector<SceneGeometry>& geometries = meshes.geometries();
  std::vector<SceneDraw> draw_data;
  for (size_t i = 0; i < instances_.size(); ++i) {
    const Mesh& mesh = scene.meshes[size_t(instances_[i].mesh)];
    uint32_t first = meshes.firstGeometry()[size_t(instances_[i].mesh)];
    if (bent_items_[i] >= 0) first = bent_.items()[size_t(bent_items_[i])].first_geometry;
    instance_data_.push_back({first, uint32_t(mesh.geometries.size()), 1});
    for (uint32_t g = 0; g < mesh.geometries.size(); ++g) {
      const SceneGeometry& geometry = geometries[first + g];
      draws_.push_back(
          {geometry.first_index, 3 * geometry.triangle_count, int32_t(geometry.first_vertex), uint32_t(i)});
      draw_data.push_back({uint32_t(i), g});
    }
  }
  geometry_buffer_ = uploads.array("scene.geometries", geometries, gpu::kReadByAddress);
  instance_buffer_ = Buffer(device_, "scene.instances", instance_data_.size() * sizeof(SceneInstance),
                            gpu::kReadByAddress, Buffer::Memory::Device);
  moves_.assign(instances_.size(), true);
  draw_buffer_ = uploads.array("scene.draws", draw_data, gpu::kReadByAddress);
}

void GpuScene::makeSet() {
  constexpr uint32_t kFrame = 0, kArrays = 1, kTextures = 2, kStructures = 3;  // shaders/shared/bindings.glsl
  const VkShaderStageFlags all = VK_SHADER_STAGE_ALL;
  const std::vector<VkDescriptorImageInfo>& textures = unposed_->surfaces.textures();
  bindings_ = {
      {kFrame, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, all, nullptr},
      {kArrays, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, all, nullptr},
      {kTextures, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, uint32_t(textures.size()), all, nullptr},
      structures_->binding(kStructures),
  };
  set_layout_ = gpu::makeSetLayout(device_, "scene", bindings_);
  set_ = gpu::DescriptorSet(device_, "scene", set_layout_.get(), bindings_);
  set_.write(kFrame, frame_);
  set_.write(kArrays, addresses_);
  set_.write(kTextures, textures);
  structures_->write(set_, kStructures);
}

void GpuScene::setFrame(gpu::Staging& staging, const FrameData& frame) const { staging.write(frame_, 0, &frame, 1); }

// Depth range of an orthographic camera: distance from the near plane to the farthest corner of all bounds; at least
// 1024 times the half height, so that depths do not depend on distant objects within that range.
double GpuScene::depthRange(uint32_t slice, const Pose& pose) const {
  const Camera& camera = pose.camera;
  double least = 1024 * camera.half_height, farthest = 0;
  dvec3 back = glm::normalize(dvec3(pose.world_from_camera[2])), eye = dvec3(pose.world_from_camera[3]);
  for (size_t i = 0; i < instances_.size() && camera.orthographic; ++i) {
    const int item = bent_items_[i];
    const dmat4& world = item < 0 ? pose.world_from_instance[i] : bent_.world(slice, size_t(item));
    const Bounds& bounds =
        item < 0 ? unposed_->meshes.bounds()[size_t(instances_[i].mesh)] : bent_.bounds(slice, size_t(item));
    if (bounds.empty()) continue;
    for (int k = 0; k < 8; ++k) {
      dvec3 corner(world * dvec4(bounds.corner(k), 1));
      farthest = std::max(farthest, glm::dot(eye - corner, back));
    }
  }
  return std::max(least, 1.001 * (farthest - camera.near));
}

static SceneCamera cameraData(const Pose& pose, double aspect, const dvec3& origin) {
  const Camera& camera = pose.camera;
  const dmat4& m = pose.world_from_camera;
  SceneCamera data;
  data.position = vec3(dvec3(m[3]) - origin);
  data.near = float(camera.near);
  data.right = vec3(glm::normalize(dvec3(m[0])));
  data.up = vec3(glm::normalize(dvec3(m[1])));
  data.forward = vec3(-glm::normalize(dvec3(m[2])));
  double half_height = camera.orthographic ? camera.half_height : std::tan(camera.vertical_fov / 2);
  data.half_extent = vec2(half_height * aspect, half_height);
  data.orthographic = camera.orthographic ? 1 : 0;
  return data;
}

// Squares of lengths up to 1e18, and sums of squares, fit single precision.
constexpr double kFarthest = 1e18;

static SceneTransform transformData(const dmat4& world_from_instance, const dvec3& origin) {
  dmat4 m = world_from_instance;
  m[3] -= dvec4(origin, 0);
  auto row = [&m](int r) { return vec4(m[0][r], m[1][r], m[2][r], m[3][r]); };
  return {row(0), row(1), row(2)};
}

static SceneLight lightData(const Light& light, const dmat4& world_from_light, const dvec3& origin) {
  SceneLight data;
  data.position = vec3(dvec3(world_from_light[3]) - origin);
  data.type = light.type == Light::Type::Directional ? LIGHT_DIRECTIONAL
              : light.type == Light::Type::Point     ? LIGHT_POINT
                                                     : LIGHT_SPOT;
  data.direction = vec3(-glm::normalize(dvec3(world_from_light[2])));
  data.range = float(light.range);
  data.intensity = light.emitted();
  data.shadow = light.shadow ? 1 : 0;
  data.cos_inner = float(std::cos(light.inner_cone));
  data.cos_outer = float(std::cos(light.outer_cone));
  return data;
}

static bool isUsable(const SceneTransform& transform) {
  bool usable = true;
  for (const vec4* row : {&transform.row_x, &transform.row_y, &transform.row_z})
    for (int i = 0; i < 4; ++i) usable = usable && std::abs((*row)[i]) < float(kFarthest);  // false for NaN
  return usable;
}

static bool isUsable(const Bounds& bounds) {
  bool usable = true;
  for (int i = 0; i < 3; ++i) usable = usable && bounds.low[i] > -kFarthest && bounds.high[i] < kFarthest;
  return usable;
}

void GpuScene::refuseTransform(int node) const {
  throw Error(kTransformLimit.text(
      fmt::format("{}: the transform of node '{}' cannot be drawn", scene_.name, scene_.nodes[size_t(node)].name)));
}

void GpuScene::setPose(gpu::Staging& staging, uint32_t slice, const Pose& pose, double aspect, const dvec3& origin,
                       const ivec4& moving) {
  STROBE_ASSERT(slice < slices_ && pose.world_from_instance.size() == instances_.size(), "slice {}", slice);
  bent_.pose(staging, slice, pose, origin);
  SceneCamera camera = cameraData(pose, aspect, origin);
  camera.depth_range = float(depthRange(slice, pose));
  camera.moving = moving;
  staging.write(cameras_, slice, &camera, 1);
  std::vector<SceneTransform> transforms;
  for (size_t i = 0; i < instances_.size(); ++i) {
    const int item = bent_items_[i];
    const dmat4& world = item < 0 ? pose.world_from_instance[i] : bent_.world(slice, size_t(item));
    transforms.push_back(transformData(world, origin));
    const bool is_bent_usable = item < 0 || isUsable(bent_.bounds(slice, size_t(item)));
    if (!isUsable(transforms[i]) || !is_bent_usable) refuseTransform(instances_[i].node);
  }
  staging.write(transforms_, slice * instances_.size(), transforms.data(), transforms.size());
  std::vector<SceneLight> lights;
  for (size_t i = 0; i < light_nodes_.size(); ++i)
    lights.push_back(lightData(pose.lights[i], pose.world_from_light[i], origin));
  staging.write(lights_, slice * lights.size(), lights.data(), lights.size());
  if (isTraced(slice)) structures_->pose(staging, levelOf(slice), transforms, moves_);
}

static uint32_t bitsOf(const scene::ScreenPath& path) {
  return (path.curved ? PATH_CURVED : 0) | (path.may_be_occluded ? PATH_MAY_BE_OCCLUDED : 0);
}

void GpuScene::setMotion(gpu::Staging& staging, const std::vector<bool>& moves,
                         const std::vector<scene::ScreenPath>& paths) {
  STROBE_ASSERT(moves.empty() || moves.size() == moves_.size(), "{} of {}", moves.size(), moves_.size());
  STROBE_ASSERT(paths.empty() || paths.size() == moves_.size(), "{} of {}", paths.size(), moves_.size());
  if (moves.empty()) moves_.assign(moves_.size(), true);
  else moves_ = moves;
  for (size_t i = 0; i < moves_.size(); ++i) {
    instance_data_[i].moves = moves_[i] ? 1 : 0;
    instance_data_[i].path = bitsOf(paths.empty() ? scene::ScreenPath() : paths[i]);
  }
  staging.write(instance_buffer_, 0, instance_data_.data(), instance_data_.size());
}

uint32_t GpuScene::movingCount() const { return uint32_t(std::count(moves_.begin(), moves_.end(), true)); }

void GpuScene::recordBuild(VkCommandBuffer commands, uint32_t first_slice, uint32_t count) const {
  STROBE_ASSERT(isTraced(first_slice) && (count == 1 || first_slice >= SLICE_SAMPLE), "slices {}, {}", first_slice,
                count);
  structures_->recordBuild(commands, levelOf(first_slice), count);
}

std::string GpuScene::layoutText() const {
  return fmt::format("{} slices, {} textures, {}", slices_, unposed_->surfaces.textures().size(),
                     int(structures_->binding(0).descriptorType));
}

}  // namespace strobe::world
