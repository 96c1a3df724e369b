// SPDX-License-Identifier: MIT
// A device with its scenes and pipelines. Every command uses a workbench.
#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>

#include "base/stamps.h"
#include "graph/graph.h"
#include "image/cryptomatte.h"
#include "lab/evaluation.h"
#include "lab/id_names.h"
#include "plan/plan.h"
#include "scene/scene_files.h"

namespace strobe::lab {

// True for a glTF file, by extension; other scenes are scripts.
bool isGltf(const std::string& scene);

// Places of the files that a Lua scene names. Names are relative to the file of the scene. Files must lie in the root
// of the scene (the project or the shipped folder), or in the folder of the scene if it has no root. `allow_outside`
// lifts this restriction.
scene::FilePlaces filePlaces(const Home& home, const std::string& scene, bool allow_outside = false);

// A scene with the moves of a shot applied and missing parts supplied, and its copies on the device, by number of
// simultaneous poses and by acceleration structure. A copy must not outlive the scene.
struct HeldScene {
  scene::Scene scene;
  Json description;    // the Lua data, or the name and hash of the file
  std::string hash;    // hash of the description
  uint64_t bytes = 0;  // bytes of meshes and textures
  double read_s = 0;   // time to read the scene
  std::vector<script::Dependency> dependencies;
  Stamps files;                                  // stamps of the dependencies
  std::string source;                            // scene name and scene settings
  std::string identity;                          // `sceneIdentity` of the shot
  std::shared_ptr<world::UnposedScene> unposed;  // shared by all copies
  double device_s = 0;                           // time of the first upload to the device
  std::map<std::pair<uint32_t, shader::StructureKind>, std::shared_ptr<world::GpuScene>> on_device;

  // Copy of the scene for `slices` poses, made if it is missing. Evicts unused copies, keeping one.
  std::shared_ptr<world::GpuScene> onDevice(const gpu::Device& device, uint32_t slices,
                                            shader::StructureKind structures);
  // Frame of a shot of this scene (lab/frame.h). The frame of the last call is kept: plan and pictures of a shot use
  // the same frame.
  const graph::Frame& frame(const Shot& shot, int earlier_frames);

 private:
  std::string frame_key_;
  graph::Frame frame_;
};

// Reads the scene of a shot. Fills in unset options of the shot (size, fps, frame, exposure). Applies --move and
// --spin.
std::shared_ptr<HeldScene> loadScene(const Home& home, Shot& shot);

// One picture, its record and its timings.
struct Picture {
  graph::FrameResult frame;  // with several sub-pixel samples: floats averaged, integers of the first
  Json record;
  Json timings;
  std::vector<std::string> warnings;                     // warnings of the scene and of the limits met
  mat4 camera_from_world = mat4(1);                      // at the raster time; the camera looks along -z, y up
  mat4 ndc_from_world = mat4(1);                         // x and y in [-1, 1], y up
  std::vector<IdName> id_names;                          // names of the ids; empty for a picture read from a file
  std::shared_ptr<const image::IdCoverage> id_coverage;  // coverage of the output "id", if requested
};

// GPU device with the caches that rendering commands share: loaded scenes, compiled pipelines and script evaluations.
// Cached parts are reused while their files are unchanged.
class Workbench {
 public:
  // Throws `Error` without a sufficient device.
  Workbench(const Home& home, const gpu::DeviceOptions& device);
  Workbench(const Home& home, const std::string& device, bool validation)
      : Workbench(home, gpu::DeviceOptions{device, validation}) {}
  // Shares the device of `other`; files come from another home folder.
  Workbench(const Home& home, const Workbench& other);
  ~Workbench();

  const Home& home() const { return home_; }
  gpu::Device& device() { return *device_; }
  const gpu::Device& device() const { return *device_; }
  graph::PipelineCache& pipelines() { return cache_; }

  // Renders a picture from the present files. Scripts, scene and shaders are reused only while no file has changed.
  // `progress` (may be empty): iterations done, total. `id_coverage`: see `Drawing::capture`.
  Picture render(const Shot& shot, const std::function<void(int, int)>& progress = {}, bool id_coverage = false);

  // Evaluation of a pipeline with settings. Reused for equal settings while no script has changed. Throws `Error`.
  std::shared_ptr<const Evaluation> evaluate(const std::string& pipeline, const script::Settings& sets);
  // Like `evaluate`, but once a pipeline has been evaluated, settings that change only numbers are applied without
  // running scripts.
  std::shared_ptr<const Evaluation> evaluateNumbers(const std::string& pipeline, const script::Settings& sets);

  // Scene of a shot; fills in unset options of the shot. Loads the scene if it is not cached; with `fresh`, also if a
  // file has changed. The cache keeps the most recently used scenes; other scenes live as long as they are in use.
  std::shared_ptr<HeldScene> scene(Shot& shot, bool fresh = false);

  // Ray-tracing backend. Throws `Error` if the device lacks the requested backend.
  graph::Backend chooseBackend(const std::string& asked) const;

  // Resource limits of scripts.
  script::Limits limits;
  // Number of frames in flight when several are drawn in sequence, at least 1. Initially 1 on a device without usable
  // time stamps, such as a software device: the host then times each pass (graph/submission.h).
  size_t frames_in_flight = 2;

  // Limit for the bytes of a frame and its scene, in addition to the free memory.
  uint64_t most_bytes = UINT64_MAX;

  // Number of compiled pipelines, and of script evaluations for pipelines, since construction.
  int compilations() const { return cache_.compilations(); }
  int evaluations() const { return evaluations_; }

 private:
  struct KnownEvaluation {
    Stamps files;
    std::shared_ptr<const Evaluation> evaluation;
  };
  void forgetScenes();

  const Home home_;
  std::shared_ptr<gpu::Device> device_;
  graph::PipelineCache cache_;
  std::list<std::shared_ptr<HeldScene>> scenes_;  // most recently used first
  std::map<std::string, KnownEvaluation> evaluated_;
  script::Texts texts_;  // of the last evaluation
  int evaluations_ = 0;
};

// Plan of a pipeline at the size of the shot, for a frame without the facts `absent` and with `outputs` (empty: all).
plan::Plan planOf(const Shot& shot, const plan::PipelineDesc& pipeline, graph::Backend backend,
                  const std::vector<std::string>& absent = {}, const std::set<std::string>& outputs = {});

}  // namespace strobe::lab
