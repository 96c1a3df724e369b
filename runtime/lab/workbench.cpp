// SPDX-License-Identifier: MIT
#include "lab/workbench.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "base/log.h"
#include "lab/record.h"
#include "plan/canonical.h"
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

static void fillShot(Shot& shot, const Json& description) {
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
      if (name.starts_with("scene.")) throw Error(fmt::format("--set {}={}: a glTF scene has no parameters", name, value));
    loaded.scene = scene::loadGltf(shot.scene);
    loaded.description["file"] = Path(shot.scene).filename().string();
    loaded.description["hash"] = hashText(readText(shot.scene));
    loaded.description["content"] = contentHash(loaded.scene);
  } else {
    loaded.description = script::evaluateScene(shot.scene, shot.sets, &loaded.dependencies);
    loaded.scene = scene::sceneFromJson(loaded.description, shot.scene);
  }
  fillShot(shot, loaded.description);
  checkShot(shot);
  for (const std::string& move : shot.moves)
    loaded.scene.motions.push_back(scene::moveFromOption(loaded.scene, move, shot.fps, shot.captureTime()));
  for (const std::string& spin : shot.spins)
    loaded.scene.motions.push_back(scene::spinFromOption(loaded.scene, spin, shot.fps, shot.captureTime()));
  scene::supplyDefaults(loaded.scene, shot.camera);
  return loaded;
}

plan::Plan planOf(const Shot& shot, const plan::PipelineDesc& pipeline, graph::Backend backend) {
  plan::CompileOptions options;
  options.width = shot.width;
  options.height = shot.height;
  options.taps = shot.taps;
  options.trace_stage = backend == graph::Backend::Pipeline ? plan::kStageTrace : plan::kStageCompute;
  return plan::compile(pipeline, options);
}

Workbench::Workbench(const std::string& device, bool validation) : device_({device, validation}), cache_(device_) {}

Workbench::~Workbench() = default;

graph::Backend Workbench::chooseBackend(const std::string& wanted) const {
  const gpu::DeviceInfo& info = device_.info();
  bool query = wanted == "query" || (wanted == "auto" && info.ray_query);
  bool present = query ? info.ray_query : info.ray_pipeline;
  if (!present)
    throw Error(fmt::format("device '{}' has no {}, which tracing backend '{}' needs; --backend auto takes what there is",
                            info.name, query ? "ray queries" : "ray tracing pipelines", wanted));
  return query ? graph::Backend::Query : graph::Backend::Pipeline;
}

// Scenes are loaded anew only when what they are made of changed.
void Workbench::useScene(Shot& shot) {
  std::string key = shot.scene + "|" + shot.camera + "|" + std::to_string(shot.fps) + "|" + std::to_string(shot.frame);
  for (const auto& part : {shot.moves, shot.spins})
    for (const std::string& text : part) key += "|" + text;
  for (const auto& [name, value] : shot.sets)
    if (name.starts_with("scene.")) key += "|" + name + "=" + value;
  if (scene_ && key == scene_key_) {
    fillShot(shot, scene_->description);
    checkShot(shot);
    return;
  }
  gpu_scenes_.clear();
  scene_.reset();
  scene_ = std::make_unique<LoadedScene>(loadScene(shot));
  scene_key_ = key;
}

// Offset of sub-pixel sample i of n from the pixel's centre: a rank-1 lattice, one sample is the centre.
static vec2 subpixelOffset(int i, int n) {
  if (n == 1) return vec2(0);
  double x = (i + 0.5) / n - 0.5;
  double y = (i + 0.5) * 0.6180339887498949;
  return vec2(x, y - std::floor(y) - 0.5);
}

// The projection a compositing program wants to know: near plane at 0, infinitely far at 1.
static dmat4 ndcFromCamera(const scene::Camera& camera, double aspect) {
  double half_height = camera.orthographic ? camera.half_height : std::tan(camera.vertical_fov / 2);
  dmat4 m(0);
  m[0][0] = 1 / (half_height * aspect);
  m[1][1] = 1 / half_height;
  if (camera.orthographic) {
    m[2][2] = -1;
    m[3][2] = -camera.near;
    m[3][3] = 1;
  } else {
    m[2][2] = m[2][3] = -1;
    m[3][2] = -camera.near;
  }
  return m;
}

static void accumulate(graph::FrameResult& sum, const graph::FrameResult& added) {
  auto add = [](std::map<std::string, graph::ReadImage>& into, const std::map<std::string, graph::ReadImage>& from) {
    for (auto& [name, read] : into) {
      const auto& values = from.at(name).floats.values;
      for (size_t i = 0; i < values.size(); ++i) read.floats.values[i] += values[i];
    }
  };
  add(sum.outputs, added.outputs);
  add(sum.taps, added.taps);
  for (size_t i = 0; i < sum.counters.size(); ++i) sum.counters[i].second += added.counters[i].second;
  for (size_t i = 0; i < sum.times.size(); ++i) {
    sum.times[i].gpu_ms += added.times[i].gpu_ms;
    sum.times[i].executions += added.times[i].executions;
  }
  sum.gpu_ms += added.gpu_ms;
}

static void divide(graph::FrameResult& sum, int n) {
  for (auto* images : {&sum.outputs, &sum.taps})
    for (auto& [name, read] : *images)
      for (float& value : read.floats.values) value /= float(n);
}

Picture Workbench::render(Shot shot, const std::function<void(int, int)>& progress) {
  double started_s = clockSeconds();
  std::vector<script::Dependency> dependencies;
  plan::PipelineDesc pipeline = script::evaluatePipeline({shot.pipeline, shot.sets}, &dependencies);
  useScene(shot);
  graph::Backend backend = chooseBackend(shot.backend);
  plan::Plan plan = planOf(shot, pipeline, backend);

  uint32_t slices = SLICE_SAMPLE + graph::Graph::sampleSlices(plan);
  auto& gpu_scene = gpu_scenes_[slices];
  if (!gpu_scene) gpu_scene = std::make_unique<scene::GpuScene>(device_, scene_->scene, slices);
  graph::Graph graph(device_, cache_, plan, *gpu_scene, backend);

  int camera_node = scene::cameraNode(scene_->scene, shot.camera);
  scene::Poser poser(scene_->scene, camera_node, shot.animation);
  graph::FrameSetup setup;
  // Stepped channels stay as they are at the capture: a jump is no motion and must not blur.
  setup.pose_at = [&](double time_s) { return poser.at(time_s, shot.captureTime()); };
  setup.camera = scene_->scene.cameras[size_t(scene_->scene.nodes[size_t(camera_node)].camera)];
  setup.capture_s = shot.captureTime();
  setup.open_s = shot.window()[0];
  setup.close_s = shot.window()[1];
  setup.frame_s = 1 / shot.fps;
  setup.anchor = anchorCode(shot.anchor);
  setup.frame = uint32_t(shot.frame);
  setup.seed = shot.seed;
  setup.environment = scene_->scene.environment;
  setup.reach = scene::reachOfMotion(scene_->scene, setup.camera, setup.pose_at, setup.capture_s, setup.open_s,
                                     setup.close_s, shot.width, shot.height);

  Picture picture;
  double ready_s = clockSeconds();
  for (int i = 0; i < shot.aa; ++i) {
    setup.subpixel = subpixelOffset(i, shot.aa);
    auto advance = [&](int done, int of) {
      if (progress) progress(i * of + done, shot.aa * of);
    };
    graph::FrameResult frame = graph.run(setup, advance);
    if (i == 0) picture.frame = std::move(frame);
    else accumulate(picture.frame, frame);
  }
  if (shot.aa > 1) divide(picture.frame, shot.aa);
  double done_s = clockSeconds();

  dmat4 camera_from_world = glm::inverse(setup.pose_at(setup.capture_s).world_from_camera);
  picture.camera_from_world = mat4(camera_from_world);
  picture.ndc_from_world = mat4(ndcFromCamera(setup.camera, double(shot.width) / shot.height) * camera_from_world);
  dependencies.insert(dependencies.end(), scene_->dependencies.begin(), scene_->dependencies.end());
  picture.record = makeRecord({shot, *scene_, plan, device_.info(), backend, dependencies}, picture.frame);
  picture.timings = makeTimings(picture.frame, device_.info(), ready_s - started_s, done_s - ready_s);
  picture.warnings = scene_->scene.warnings;
  return picture;
}

}  // namespace strobe::lab
