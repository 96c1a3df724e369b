// SPDX-License-Identifier: MIT
// Many pictures in one process. Scripts run once for every graph they make, not for every value; plans, scenes,
// pipelines and images are kept; what would come out the same is drawn once. What files held when they were first read
// counts as long as the batch keeps what was made of them.
#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "lab/drawing.h"

namespace strobe::lab {

// A pipeline evaluated with some settings, or why it cannot be.
struct Evaluated {
  std::shared_ptr<const Evaluation> evaluation;        // null if refused
  std::shared_ptr<const plan::PipelineDesc> pipeline;  // its description, or null
  std::string refusal;
};

// A pipeline does not take the settings; any other error is one of the scene or the program.
struct Refusal : Error {
  using Error::Error;
};

// What decides which pictures a plan makes: the plan without the names of the pipeline and of values that no pass uses.
std::string identityOf(const plan::Plan& plan);

// Milliseconds of a shot's frames, each a frame of every shot in turn.
struct Timing {
  std::vector<double> ms;                                           // by round
  std::vector<double> interval_ms;                                  // by round, by the clock: from frame to frame
  std::vector<std::pair<std::string, std::vector<double>>> passes;  // of each node in the order of execution, by round
  double median = 0;
  double low = 0, high = 0;  // quartiles
  // Of the last round.
  std::vector<int> executions;                             // of each node, as `passes`
  std::vector<std::pair<std::string, uint64_t>> counters;  // "node.counter"
};

// How often: `least` rounds, and more, up to `most`, until the 95 % interval of each median is at most `within` of it
// to either side.
struct Rounds {
  int least = 1, most = 1;
  double within = 0;
};

class Batch {
 public:
  // Outputs ("color") and taps ("node.port") to read back; empty: all.
  using Outputs = std::set<std::string>;
  using Progress = std::function<void(int done, int of)>;

  // The bench must outlive it.
  explicit Batch(Workbench& bench) : bench_(bench) {}

  Workbench& bench() { return bench_; }

  // A pipeline with those of `sets` that are not the scene's. Settings that decide nothing but numbers are put into the
  // description without running scripts.
  Evaluated evaluate(const std::string& pipeline, const script::Settings& sets);
  // The pipeline of the registry that declares this kind: the raster image without blur, or truth.
  const std::string& nameOf(plan::PipelineDesc::Kind kind);
  // The shot with what its scene suggests.
  Shot filled(const Shot& shot);
  // Throws `Refusal`, or `Error` for what cannot be loaded or built; so do the following.
  std::shared_ptr<const plan::Plan> planOf(const Shot& shot);

  // Identity of a picture before it is drawn: equal where scripts, shaders, settings and the scene's content, wherever
  // its file lies, lead to the same images on one device by one program.
  std::string contentOf(const Shot& shot);
  // The files behind every content so far: scripts, shaders, files of scenes.
  const std::set<Path>& inputs() const { return inputs_; }

  // What `Workbench::render` gives. Pictures are kept (by canonical(shot) and outputs) until they fill
  // `kept_picture_bytes`, those used last longest.
  std::shared_ptr<const Picture> picture(const Shot& shot, const Outputs& outputs = {}, const Progress& progress = {});
  // Asked first for a picture with all outputs that is not kept, by its content (contentOf); gives null where it does
  // not draw it.
  std::function<std::shared_ptr<const Picture>(const std::string& content, const Progress& progress)> source;
  // Four channels of a single sample in the pixel's centre; equal plans and frames are drawn once, whatever names and
  // settings led to them.
  std::shared_ptr<const image::Image> color(const Shot& shot);
  // Forgets colours drawn by a pipeline; evaluations, scenes and pictures by other pipelines stay.
  void forgetColorsOf(const std::string& pipeline);

  // Draws a frame of each shot in turn, round after round, of which the colour alone is asked for and nothing is read
  // back; a first frame of each, which may pay for compiling, does not count. Where several can be under way at once
  // (`frames_in_flight` of the bench) it is several frames, one behind the other, of which the last is timed. On a
  // software device times are only comparable within one call.
  std::vector<Timing> timeInTurn(const std::vector<Shot>& shots, const Rounds& rounds);

  int drawn() const { return drawn_; }  // pictures and colours, without frames that were timed

  size_t kept_picture_bytes = size_t{256} << 20;
  // Of the graphs that are kept to be drawn again: their images, and how many there are.
  size_t kept_image_bytes = size_t{512} << 20;
  size_t kept_graphs = 32;

 private:
  struct KnownPlan {
    Planned planned;
    std::string identity;
  };
  struct Kept {
    std::string key;
    std::shared_ptr<const Picture> picture;
    size_t bytes = 0;
  };
  Evaluated byScripts(const std::string& pipeline, const script::Settings& sets);
  std::shared_ptr<const Evaluation> derived(const std::string& pipeline, const script::Settings& sets);
  const KnownPlan& known(const Shot& filled, const HeldScene& scene, const Outputs& outputs = {});
  Drawing& drawing(const Shot& filled, const std::shared_ptr<HeldScene>& scene, const Outputs& outputs = {});
  void makeRoom(const plan::Plan& plan);
  const std::string& shadersOf(const plan::PassDesc& pass, graph::Backend backend);
  void keep(Kept kept);

  Workbench& bench_;
  std::map<std::string, Evaluated> by_scripts_, derived_;
  std::map<plan::PipelineDesc::Kind, std::string> names_;
  std::map<std::string, KnownPlan> plans_;
  std::map<std::string, std::string> shaders_;  // hashes of the files of a pass, by its shader and the backend
  std::set<Path> inputs_;
  std::list<std::unique_ptr<Drawing>> drawings_;  // used last first
  std::map<std::string, std::shared_ptr<const image::Image>> colors_;
  std::list<Kept> pictures_;  // used last first
  size_t pictures_bytes_ = 0;
  int drawn_ = 0;
};

}  // namespace strobe::lab
