// SPDX-License-Identifier: MIT
// Many pictures in one process. The batch caches plans, scenes, pipelines and images. Scripts run once per graph, not
// once per value, and equal pictures are drawn once. The batch does not read a file again while it holds results from
// this file.
#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "lab/kept_drawings.h"

namespace strobe::lab {

// Thrown if a pipeline does not accept the settings. Other errors come from the scene or the program.
struct Refusal : Error {
  using Error::Error;
};

// Identity of the pictures of a plan: the plan without the pipeline name and without values that no pass uses.
std::string identityOf(const plan::Plan& plan);

// Frame times of a shot, milliseconds. A round draws one frame of every shot.
struct Timing {
  std::vector<double> ms;                                           // GPU time by round
  std::vector<double> interval_ms;                                  // by round: wall clock from frame to frame
  std::vector<std::pair<std::string, std::vector<double>>> passes;  // by node in execution order, then by round
  // From the last round.
  std::vector<int> executions;                             // by node, in the order of `passes`
  std::vector<std::pair<std::string, uint64_t>> counters;  // "node.counter"
};

// Number of rounds: at least `least`, then more until the 95 % interval of each median lies within the fraction
// `within` of the median on both sides, at most `most`.
struct Rounds {
  int least = 1, most = 1;
  double within = 0;
};

// Cache and renderer for many shots in one process: evaluates pipelines, draws and times pictures, and reuses plans,
// scenes, GPU pipelines and images. Equal pictures are drawn once.
class Batch {
 public:
  // Outputs ("color") and taps ("node.port") to read back; empty: all.
  using Outputs = std::set<std::string>;
  using Progress = std::function<void(int done, int of)>;

  // The bench must outlive the batch.
  explicit Batch(Workbench& bench) : drawings(bench), bench_(bench) {}

  Workbench& bench() { return bench_; }

  // Description of a pipeline with `sets`; ignores scene settings. Settings that change only numbers are applied to the
  // description without running scripts. Throws `Refusal`.
  std::shared_ptr<const plan::PipelineDesc> evaluate(const std::string& pipeline, const script::Settings& sets);
  // True if `evaluate` does not throw.
  bool accepts(const std::string& pipeline, const script::Settings& sets);
  // Name of the pipeline in the registry that declares this kind: the raster image without blur, or truth.
  const std::string& nameOf(plan::PipelineDesc::Kind kind);
  // The shot, with unset options filled in from its scene.
  Shot filled(const Shot& shot);
  // Throws `Refusal`, or `Error` if something cannot be loaded or built. The functions below throw likewise.
  std::shared_ptr<const plan::Plan> planOf(const Shot& shot);

  // Identity of a picture before it is drawn. Pictures of equal identity are equal on one device with one program. The
  // identity covers the plan, shaders, settings and the content of the scene, but neither comments nor the path of the
  // scene.
  std::string contentOf(const Shot& shot);
  // Input files of all `contentOf` calls so far: scripts, shaders and scene files.
  const std::set<Path>& inputs() const { return inputs_; }

  // Same picture as from `Workbench::render`. Cached by canonical(shot) and outputs up to `kept_picture_bytes`; the
  // least recently used picture is evicted first.
  std::shared_ptr<const Picture> picture(const Shot& shot, const Outputs& outputs = {}, const Progress& progress = {});
  // Optional other source of pictures, for pictures that are not cached and have all outputs. `content` is the value of
  // `contentOf`. Null result: the batch draws the picture.
  std::function<std::shared_ptr<const Picture>(const std::string& content, const Progress& progress)> source;
  // Colour image of a shot: four channels, one sample at the pixel centre. Shots of one pipeline with equal plan, frame
  // and scene share one image.
  std::shared_ptr<const image::Image> color(const Shot& shot);
  // Drops the colour images of a pipeline. Evaluations, scenes and pictures stay cached.
  void forgetColorsOf(const std::string& pipeline);

  // Draws one frame of each shot per round, with the colour as its only output and no readback. The first frame of each
  // shot may include compilation and is not counted. If the bench allows several frames in flight (`frames_in_flight`),
  // a round draws several frames of a shot in sequence and times the last one. On a software device, times are
  // comparable only within one call.
  std::vector<Timing> timeInTurn(const std::vector<Shot>& shots, const Rounds& rounds);

  int drawn() const { return drawn_; }  // number of pictures and colour images, without timed frames

  size_t kept_picture_bytes = size_t{256} << 20;
  KeptDrawings drawings;  // graphs of earlier pictures

 private:
  // Evaluation of a pipeline with settings, or the reason of a refusal.
  struct Evaluated {
    std::shared_ptr<const Evaluation> evaluation;  // null if refused
    std::string refusal;
  };
  struct KnownPlan {
    Planned planned;
    std::string identity;
  };
  struct Kept {
    std::string key;
    std::shared_ptr<const Picture> picture;
    size_t bytes = 0;
  };
  const Evaluated& byScripts(const std::string& pipeline, const script::Settings& sets);
  const Evaluated& evaluated(const std::string& pipeline, const script::Settings& sets);
  std::shared_ptr<const Evaluation> accepted(const std::string& pipeline, const script::Settings& sets);
  const KnownPlan& known(const Shot& filled, HeldScene& scene, const Outputs& outputs = {});
  Drawing& drawing(const Shot& filled, const std::shared_ptr<HeldScene>& scene, const Outputs& outputs = {});
  const std::string& shadersOf(const plan::PassDesc& pass, graph::Backend backend);
  void keep(Kept kept);

  Workbench& bench_;
  std::map<std::string, Evaluated> by_scripts_, derived_;
  std::map<plan::PipelineDesc::Kind, std::string> names_;
  std::map<std::string, KnownPlan> plans_;
  std::map<std::string, std::string> shaders_;  // hashes (base/inputs.h) of the files of a pass, by shader and backend
  std::set<Path> inputs_;
  std::map<std::string, std::shared_ptr<const image::Image>> colors_;
  std::list<Kept> pictures_;  // most recently used first
  size_t pictures_bytes_ = 0;
  int drawn_ = 0;
};

}  // namespace strobe::lab
