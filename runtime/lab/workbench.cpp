// SPDX-License-Identifier: MIT
#include "lab/workbench.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "base/log.h"
#include "lab/frame.h"
#include "lab/kept_drawings.h"
#include "lab/shot_options.h"
#include "scene/bend.h"
#include "scene/defaults.h"
#include "scene/gltf.h"
#include "scene/json_scene.h"
#include "scene/kept_textures.h"
#include "scene/motion.h"
#include "world/fits.h"

namespace strobe::lab {

bool isGltf(const std::string& scene) { return hasExtension(scene, ".glb") || hasExtension(scene, ".gltf"); }

// Hash of meshes and textures, independent of their files.
static std::string contentHash(const scene::Scene& scene) {
  std::string hashes;
  auto add = [&](const auto& values) {
    if (!values.empty()) hashes += hashBytes(values.data(), values.size() * sizeof values[0]);
  };
  for (const scene::Mesh& mesh : scene.meshes) {
    for (const scene::Geometry& geometry : mesh.geometries) {
      hashes += hashBytes(geometry.vertices.data(), geometry.vertices.size() * sizeof(scene::Vertex));
      hashes += hashBytes(geometry.indices.data(), geometry.indices.size() * sizeof(uint32_t));
      add(geometry.influences.joints), add(geometry.influences.shares), add(geometry.tangents);
      for (const scene::MorphTarget& target : geometry.targets)
        add(target.positions), add(target.normals), add(target.tangents);
    }
  }
  for (const scene::Skin& skin : scene.skins) add(skin.inverse_binds);
  for (const scene::Texture& texture : scene.textures)
    for (const auto& level : texture.levels) hashes += hashBytes(level.data(), level.size());
  return hashText(hashes);
}

static uint64_t bytesOf(const scene::Scene& scene) {
  uint64_t bytes = 0;
  for (const scene::Mesh& mesh : scene.meshes)
    for (const scene::Geometry& geometry : mesh.geometries) {
      bytes += geometry.vertices.size() * sizeof(scene::Vertex) + geometry.indices.size() * sizeof(uint32_t);
      bytes += geometry.influences.joints.size() * (sizeof(uint32_t) + sizeof(double));
      bytes += geometry.tangents.size() * sizeof(vec4);
      for (const scene::MorphTarget& target : geometry.targets)
        bytes += (target.positions.size() + target.normals.size() + target.tangents.size()) * sizeof(vec3);
    }
  for (const scene::Texture& texture : scene.textures)
    for (const auto& level : texture.levels) bytes += level.size();
  return bytes;
}

// Display path of a file that a scene names, relative in the same way as the path of the scene.
static std::string shownBeside(const std::string& scene, const Path& file) {
  Path own = std::filesystem::absolute(scene).lexically_normal();
  return (Path(scene).parent_path() / file.lexically_relative(own.parent_path())).lexically_normal().string();
}

scene::FilePlaces filePlaces(const Home& home, const std::string& scene, bool allow_outside) {
  scene::FilePlaces places{script::sceneFolder(home, scene), {}, allow_outside};
  for (const Path& root : home.roots())
    if (places.root.empty() && liesIn(places.folder, root)) places.root = root;
  return places;
}

// Throws the error of `find` with the place "--camera NAME" if an option names a part that the scene lacks.
template <class Find>
static void requirePart(const std::string& option, const std::string& name, const Find& find) {
  try {
    find();
  } catch (const Error& error) {
    throw Error(error.message(), {"--" + option + " " + name}, error.exitCode());
  }
}

// Supplies the default camera and light. Checks the parts that the shot names.
static void completeScene(scene::Scene& scene, const Shot& shot) {
  requirePart("camera", shot.camera, [&] {
    scene::supplyDefaults(scene, shot.camera);
    scene::cameraNode(scene, shot.camera);
  });
  requirePart("animation", shot.animation, [&] { scene::clipsOf(scene, shot.animation); });
  if (!shot.follow.empty()) requirePart("follow", shot.follow, [&] { scene::nodeByName(scene, shot.follow); });
}

std::shared_ptr<HeldScene> loadScene(const Home& home, Shot& shot) {
  auto held = std::make_shared<HeldScene>();
  HeldScene& loaded = *held;
  const double started_s = clockSeconds();
  if (isGltf(shot.scene)) {
    for (const auto& [name, value] : shot.sets)
      if (name.starts_with("scene."))
        throw Error(fmt::format("--set {}={}: a glTF scene has no parameters", name, plan::textOf(value)), {}, 2);
    loaded.scene = scene::loadGltf(shot.scene, {shot.allow_outside, shot.variant});
    loaded.description["file"] = Path(shot.scene).filename().string();
    loaded.description["hash"] = loaded.scene.files.front().hash;
    loaded.description["content"] = contentHash(loaded.scene);
    for (const scene::SourceFile& file : loaded.scene.files)
      loaded.dependencies.push_back({file.path, shownBeside(shot.scene, file.path), file.hash});
  } else {
    if (!shot.variant.empty())
      throw Error(fmt::format("--variant {}: only glTF scenes have variants of materials", shot.variant), {}, 2);
    loaded.description = script::evaluateScene(home, shot.scene, shot.sets, &loaded.dependencies);
    loaded.scene = scene::sceneFromJson(loaded.description, shot.scene, suggestions(), scene::keptPainter(home.cache()),
                                        filePlaces(home, shot.scene, shot.allow_outside));
    for (const scene::SourceFile& file : loaded.scene.files) {
      loaded.description["files"][home.shown(file.path)] = file.hash;
      loaded.dependencies.push_back({file.path, home.shown(file.path), file.hash});
    }
  }
  fillShot(shot, loaded.description);
  checkShot(shot);
  for (const std::string& move : shot.moves)
    loaded.scene.motions.push_back(scene::moveFromOption(loaded.scene, move, shot.fps, shot.restTime()));
  for (const std::string& spin : shot.spins)
    loaded.scene.motions.push_back(scene::spinFromOption(loaded.scene, spin, shot.fps, shot.restTime()));
  for (scene::Material& material : loaded.scene.materials)
    material.double_sided = material.double_sided || shot.faces == "both";
  completeScene(loaded.scene, shot);
  loaded.hash = hashText(loaded.description.dump());
  loaded.bytes = bytesOf(loaded.scene);
  scene::findBounds(loaded.scene);
  loaded.read_s = clockSeconds() - started_s;
  return held;
}

// Evicts unused copies. A copy is as large as the scene, and a dragged slider may request many numbers of poses in
// sequence.
std::shared_ptr<world::GpuScene> HeldScene::onDevice(const gpu::Device& device, uint32_t slices,
                                                     shader::StructureKind structures) {
  std::shared_ptr<world::GpuScene>& held = on_device[{slices, structures}];
  if (!held) {
    const double started_s = clockSeconds();
    world::requireFits(scene, slices, structures, gpu::limitsOf(device));
    if (!unposed) unposed = std::make_shared<world::UnposedScene>(device, scene);
    held = std::make_shared<world::GpuScene>(device, scene, slices, unposed, structures);
    if (device_s == 0) device_s = clockSeconds() - started_s;
  }
  std::shared_ptr<world::GpuScene> copy = held;
  for (auto it = on_device.begin(); it != on_device.end() && on_device.size() > 2;)
    it = it->second.use_count() == 1 ? on_device.erase(it) : std::next(it);
  return copy;
}

const graph::Frame& HeldScene::frame(const Shot& shot, int earlier_frames) {
  std::string key = fmt::format("{}|{}x{}|{}|{}|{}", frameIdentity(shot), shot.width, shot.height, shot.camera,
                                shot.model_everything, earlier_frames);
  if (key != frame_key_) frame_ = frameOf(shot, scene, earlier_frames);
  frame_key_ = std::move(key);
  return frame_;
}

plan::Plan planOf(const Shot& shot, const plan::PipelineDesc& pipeline, graph::Backend backend,
                  const std::vector<std::string>& absent, const std::set<std::string>& outputs) {
  plan::CompileOptions options;
  options.width = shot.width;
  options.height = shot.height;
  options.taps = shot.taps;
  options.absent = absent;
  options.outputs = outputs;
  options.trace_stage = shader::rowOf(backend).has_stages ? plan::kStageTrace : plan::kStageCompute;
  plan::Plan plan = plan::compile(pipeline, options);
  plan::requireWholeOutputs(plan);
  return plan;
}

Workbench::Workbench(const Home& home, const gpu::DeviceOptions& device)
    : home_(home), device_(std::make_shared<gpu::Device>(device)), cache_(home, *device_) {
  if (!device_->measuresTimes()) frames_in_flight = 1;
}

Workbench::Workbench(const Home& home, const Workbench& other)
    : limits(other.limits),
      frames_in_flight(other.frames_in_flight),
      home_(home),
      device_(other.device_),
      cache_(home, *device_) {}

Workbench::~Workbench() = default;

graph::Backend Workbench::chooseBackend(const std::string& asked) const {
  return shader::chooseBackend(device_->info(), asked);
}

// ---- scripts

std::shared_ptr<const Evaluation> Workbench::evaluate(const std::string& pipeline, const script::Settings& sets) {
  constexpr size_t kMost = 1024;
  std::string key = pipeline + settingsIdentity(sets, false);
  auto known = evaluated_.find(key);
  if (known != evaluated_.end() && known->second.files.current()) return known->second.evaluation;
  if (known != evaluated_.end()) evaluated_.erase(known);
  if (evaluated_.size() >= kMost) evaluated_.clear();
  ++evaluations_;
  auto evaluation = std::make_shared<Evaluation>(evaluated(home_, pipeline, sets, limits, texts_));
  texts_ = evaluation->texts;
  // Stamps before contents: a change in between then makes them differ.
  Stamps files = stampsOf(evaluation->scripts);
  if (isCurrent(evaluation->scripts)) evaluated_[key] = {std::move(files), evaluation};
  return evaluation;
}

std::shared_ptr<const Evaluation> Workbench::evaluateNumbers(const std::string& pipeline,
                                                             const script::Settings& sets) {
  auto by_scripts = [&](const script::Settings& deciding) -> std::shared_ptr<const Evaluation> {
    try {
      return evaluate(pipeline, deciding);
    } catch (const Error&) {
      return nullptr;
    }
  };
  auto known = evaluated_.lower_bound(pipeline);
  const bool is_known = known != evaluated_.end() && known->first.starts_with(pipeline);
  std::shared_ptr<const Evaluation> evaluation;
  if (is_known) evaluation = derivedEvaluation(pipelineSettings(sets), by_scripts);
  return evaluation ? evaluation : evaluate(pipeline, sets);
}

// ---- scenes

static std::string sourceOf(const Shot& shot) { return shot.scene + settingsIdentity(shot.sets, true); }

std::shared_ptr<HeldScene> Workbench::scene(Shot& shot, bool fresh) {
  std::string source = sourceOf(shot);
  for (auto known = scenes_.begin(); known != scenes_.end(); ++known) {
    HeldScene& held = **known;
    if (held.source != source) continue;
    Shot filled = shot;
    fillShot(filled, held.description);
    if (sceneIdentity(filled) != held.identity) continue;
    if (fresh && !held.files.current()) {
      Stamps stamps = stampsOf(held.dependencies);
      if (!isCurrent(held.dependencies)) break;
      held.files = std::move(stamps);
    }
    checkShot(filled);
    shot = filled;
    scenes_.splice(scenes_.begin(), scenes_, known);
    return scenes_.front();
  }
  std::shared_ptr<HeldScene> held = loadScene(home_, shot);
  held->files = stampsOf(held->dependencies);
  held->source = source;
  held->identity = sceneIdentity(shot);
  std::erase_if(scenes_, [&](const auto& known) { return known->identity == held->identity; });
  scenes_.push_front(held);
  forgetScenes();
  return held;
}

void Workbench::forgetScenes() {
  constexpr size_t kMost = 64;
  constexpr uint64_t kMostBytes = uint64_t{1} << 30;
  uint64_t bytes = 0;
  size_t count = 0;
  for (auto known = scenes_.begin(); known != scenes_.end();) {
    bytes += (*known)->bytes;
    bool goes = count > 0 && (bytes > kMostBytes || count >= kMost);
    known = goes ? scenes_.erase(known) : std::next(known);
    ++count;
  }
}

Picture Workbench::render(const Shot& shot, const std::function<void(int, int)>& progress, bool id_coverage) {
  return KeptDrawings(*this).render(shot, progress, id_coverage);
}

}  // namespace strobe::lab
