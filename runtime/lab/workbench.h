// SPDX-License-Identifier: MIT
// A device, the scenes it holds and the pipelines made on it: the object every command drives.
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

// A scene with the moves of a shot applied and what it lacked supplied.
struct LoadedScene {
  scene::Scene scene;
  Json description;                // what identifies it: the Lua data, or the name and hash of the file
  std::string hash;                // of the description
  uint64_t bytes = 0;              // of meshes and textures
  double read_s = 0, order_s = 0;  // what it took to read it, to order its triangles
  std::vector<script::Dependency> dependencies;
};

// Not a script, by the ending of its name.
bool isGltf(const std::string& scene);

// Places of the files that a Lua scene names. Names are relative to the scene's file. Files lie in the root that has
// the scene (the project or the shipped folder), without such a root in the scene's folder.
scene::FilePlaces filePlaces(const Home& home, const std::string& scene, bool allow_outside = false);

// Reads the scene, fills in what the shot left open from it (size, fps, frame, exposure), applies --move and --spin.
LoadedScene loadScene(const Home& home, Shot& shot);

// A loaded scene and its copies on the device, by how many times they can be posed at once and by what rays traverse in
// them. A copy must not outlive it.
struct HeldScene {
  LoadedScene loaded;
  std::shared_ptr<world::UnposedScene> unposed;  // of all copies
  double device_s = 0;                           // what it took to bring it to the device, the first time
  std::map<std::pair<uint32_t, shader::StructureKind>, std::shared_ptr<world::GpuScene>> on_device;

  // Copy of the scene for `slices` poses, made if it is missing. Evicts unused copies, keeping one.
  std::shared_ptr<world::GpuScene> onDevice(const gpu::Device& device, uint32_t slices,
                                            shader::StructureKind structures);
};

// One picture, its record and its timings.
struct Picture {
  graph::FrameResult frame;  // of several sub-pixel samples: floats averaged, integers of the first
  Json record;
  Json timings;
  std::vector<std::string> warnings;                     // of the scene, and the limits that were met
  mat4 camera_from_world = mat4(1);                      // at the raster time; the camera looks along -z, y up
  mat4 ndc_from_world = mat4(1);                         // x and y in [-1, 1], y up
  std::vector<IdName> id_names;                          // what its ids stand for; empty if it was read from a file
  std::shared_ptr<const image::IdCoverage> id_coverage;  // of the output "id", where it was requested
};

class Workbench {
 public:
  // Throws `Error` without a sufficient device.
  Workbench(const Home& home, const gpu::DeviceOptions& device);
  Workbench(const Home& home, const std::string& device, bool validation)
      : Workbench(home, gpu::DeviceOptions{device, validation}) {}
  // On the device of another, with files from elsewhere.
  Workbench(const Home& home, const Workbench& other);
  ~Workbench();

  const Home& home() const { return home_; }
  gpu::Device& device() { return *device_; }
  const gpu::Device& device() const { return *device_; }
  graph::PipelineCache& pipelines() { return cache_; }

  // Renders. Scripts run, and scene and shaders are read, unless that was done before and no file changed since; so a
  // picture is always that of the files as they are. `progress` (may be empty): iterations done, of. `id_coverage`: as
  // `Drawing::capture`.
  Picture render(const Shot& shot, const std::function<void(int, int)>& progress = {}, bool id_coverage = false);

  // What the pipeline's scripts give, run unless they were with the same settings and no file of theirs changed since.
  // Throws `Error`.
  std::shared_ptr<const Evaluation> evaluate(const std::string& pipeline, const script::Settings& sets);

  // The scene of a shot, whose gaps it fills. It is loaded unless it is held already; with `fresh` also if a file it
  // was made of changed. Those used last are held, others as long as they are in use.
  std::shared_ptr<HeldScene> scene(Shot& shot, bool fresh = false);

  // How rays are traced; throws `Error` where the device cannot do what is asked for.
  graph::Backend chooseBackend(const std::string& asked) const;

  // What scripts may use.
  script::Limits limits;
  // Frames that are under way at once where several are drawn one after the other: at least 1, which it is on a
  // software device unless it is set, since that has no clock for its passes (graph/submission.cpp).
  size_t frames_in_flight = 2;

  // Bytes that a frame and its scene may take at most, where more is free.
  uint64_t most_bytes = UINT64_MAX;

  // Pipelines compiled, and scripts run for pipelines, since the workbench exists.
  int compilations() const { return cache_.compilations(); }
  int evaluations() const { return evaluations_; }

 private:
  struct KnownScene {
    std::string identity;
    std::string source;  // the file and its settings
    Stamps files;
    std::shared_ptr<HeldScene> held;
  };
  struct KnownEvaluation {
    Stamps files;
    std::shared_ptr<const Evaluation> evaluation;
  };
  void forgetScenes();

  const Home home_;
  std::shared_ptr<gpu::Device> device_;
  graph::PipelineCache cache_;
  std::list<KnownScene> scenes_;  // used last first
  Evaluator evaluator_{home_, limits};
  std::map<std::string, KnownEvaluation> evaluated_;
  int evaluations_ = 0;
};

// How the frame of a shot sees the scene, which must outlive what is returned; paths are those since `earlier_frames`
// before it (plan::earlierFrames), at least since one.
graph::FrameSetup frameSetup(const Shot& shot, const scene::Scene& scene, int earlier_frames = 1);

// The plan of a shot's pipeline at its size, for a frame that lacks the facts `absent` and is asked for `outputs`
// (empty: all).
plan::Plan planOf(const Shot& shot, const plan::PipelineDesc& pipeline, graph::Backend backend,
                  const std::vector<std::string>& absent = {}, const std::set<std::string>& outputs = {});

}  // namespace strobe::lab
