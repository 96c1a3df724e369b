// SPDX-License-Identifier: MIT
#include "lab/workbench.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "lab/session.h"
#include "scene/defaults.h"
#include "scene/gltf.h"
#include "scene/json_scene.h"
#include "scene/motion.h"

namespace strobe::lab {

static bool isGltf(const std::string& scene) { return scene.ends_with(".glb") || scene.ends_with(".gltf"); }

// A number the scene suggests for a shot ("shot" in its description), or `otherwise`.
static double suggested(const Json& description, const char* name, double otherwise) {
  if (!description.contains("shot") || !description["shot"].contains(name)) return otherwise;
  return description["shot"][name].get<double>();
}

void fillShot(Shot& shot, const Json& description) {
  if (shot.width == 0) {
    shot.width = int(suggested(description, "width", 960));
    shot.height = int(suggested(description, "height", 540));
  }
  if (shot.fps == 0) shot.fps = suggested(description, "fps", 24);
  if (shot.frame == -1) shot.frame = int(suggested(description, "frame", 1));
  if (shot.exposure == -1) shot.exposure = suggested(description, "exposure", 0.5);
}

// Identity of meshes and textures, wherever a file keeps them.
static std::string contentHash(const scene::Scene& scene) {
  std::string hashes;
  for (const scene::Mesh& mesh : scene.meshes) {
    for (const scene::Geometry& geometry : mesh.geometries) {
      hashes += hashBytes(geometry.vertices.data(), geometry.vertices.size() * sizeof(scene::Vertex));
      hashes += hashBytes(geometry.indices.data(), geometry.indices.size() * sizeof(uint32_t));
    }
  }
  for (const scene::Texture& texture : scene.textures)
    for (const auto& level : texture.levels) hashes += hashBytes(level.data(), level.size());
  return hashText(hashes);
}

LoadedScene loadScene(Shot& shot) {
  LoadedScene loaded;
  if (isGltf(shot.scene)) {
    for (const auto& [name, value] : shot.sets)
      if (name.starts_with("scene."))
        throw Error(fmt::format("--set {}={}: a glTF scene has no parameters", name, value));
    loaded.scene = scene::loadGltf(shot.scene);
    loaded.description["file"] = Path(shot.scene).filename().string();
    loaded.description["hash"] = hashText(readText(shot.scene));
    loaded.description["content"] = contentHash(loaded.scene);
    loaded.dependencies = {
        {std::filesystem::absolute(shot.scene).lexically_normal(), shot.scene, loaded.description["hash"]}};
  } else {
    loaded.description = script::evaluateScene(shot.scene, shot.sets, &loaded.dependencies);
    loaded.scene = scene::sceneFromJson(loaded.description, shot.scene);
  }
  fillShot(shot, loaded.description);
  checkShot(shot);
  for (const std::string& move : shot.moves)
    loaded.scene.motions.push_back(scene::moveFromOption(loaded.scene, move, shot.fps, shot.restTime()));
  for (const std::string& spin : shot.spins)
    loaded.scene.motions.push_back(scene::spinFromOption(loaded.scene, spin, shot.fps, shot.restTime()));
  scene::supplyDefaults(loaded.scene, shot.camera);
  return loaded;
}

// A copy is as large as the scene: a dragged slider that asks for one number after the other must not leave them all.
std::shared_ptr<scene::GpuScene> HeldScene::onDevice(const gpu::Device& device, uint32_t slices) {
  std::shared_ptr<scene::GpuScene>& wanted = on_device[slices];
  if (!wanted) wanted = std::make_shared<scene::GpuScene>(device, loaded.scene, slices);
  std::shared_ptr<scene::GpuScene> copy = wanted;
  for (auto it = on_device.begin(); it != on_device.end() && on_device.size() > 2;)
    it = it->second.use_count() == 1 ? on_device.erase(it) : std::next(it);
  return copy;
}

plan::Plan planOf(const Shot& shot, const plan::PipelineDesc& pipeline, graph::Backend backend) {
  plan::CompileOptions options;
  options.width = shot.width;
  options.height = shot.height;
  options.taps = shot.taps;
  options.trace_stage = backend == graph::Backend::Pipeline ? plan::kStageTrace : plan::kStageCompute;
  return plan::compile(pipeline, options);
}

Workbench::Workbench(const gpu::DeviceOptions& device) : device_(device), cache_(device_) {}

Workbench::~Workbench() = default;

graph::Backend Workbench::chooseBackend(const std::string& wanted) const {
  const gpu::DeviceInfo& info = device_.info();
  bool query = wanted == "query" || (wanted == "auto" && info.ray_query);
  bool present = query ? info.ray_query : info.ray_pipeline;
  if (!present)
    throw Error(
        fmt::format("device '{}' has no {}, which tracing backend '{}' needs; --backend auto takes what there is",
                    info.name, query ? "ray queries" : "ray tracing pipelines", wanted));
  return query ? graph::Backend::Query : graph::Backend::Pipeline;
}

// What of a shot decides its scene.
static std::string sceneKey(const Shot& shot) {
  std::string key = shot.scene + "|" + shot.camera;
  if (!shot.moves.empty() || !shot.spins.empty()) key += fmt::format("|{}|{}", shot.fps, shot.restTime());
  for (const auto& part : {shot.moves, shot.spins})
    for (const std::string& text : part) key += "|" + text;
  for (const auto& [name, value] : shot.sets)
    if (name.starts_with("scene.")) key += "|" + name + "=" + value;
  return key;
}

static bool isCurrent(const LoadedScene& loaded) {
  return std::all_of(loaded.dependencies.begin(), loaded.dependencies.end(),
                     [](const auto& file) { return script::hashOfPath(file.path) == file.hash; });
}

std::shared_ptr<HeldScene> Workbench::scene(Shot& shot, bool fresh) {
  if (scene_) {
    Shot filled = shot;
    fillShot(filled, scene_->loaded.description);
    if (sceneKey(filled) == scene_key_ && (!fresh || isCurrent(scene_->loaded))) {
      checkShot(filled);
      shot = filled;
      return scene_;
    }
  }
  auto held = std::make_shared<HeldScene>();
  held->loaded = loadScene(shot);
  scene_ = held;
  scene_key_ = sceneKey(shot);
  return held;
}

Picture Workbench::render(const Shot& shot, const std::function<void(int, int)>& progress) {
  return Session(*this, shot).capture(progress);
}

}  // namespace strobe::lab
