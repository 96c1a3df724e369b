// SPDX-License-Identifier: MIT
// A shot that stays: its values can be changed and the files it came from edited while it is drawn. Every change is a
// transaction: the new version is evaluated, compiled and planned beside the running one and takes its place only when
// all of it is sound; what is not sound keeps its last good version. The window, captures and tests drive this.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lab/drawing.h"
#include "lab/shot_options.h"
#include "lab/watched_files.h"

namespace strobe::lab {

// A value that can be changed, as a panel shows it.
struct Control {
  plan::ParamDesc declaration;  // `name` as `set` takes it: "exposure", "samples", "edge.depth_threshold"
  plan::Value value;
  std::string group;   // "shot", "pipeline", or the name of a node
  std::string origin;  // who set it: "default", "preset best", "scene", "follows samples", "window", ...
  std::string place;   // where it is declared, "file:line", or ""
  bool set = false;    // by `set` or the shot given: `unset` gives it back to its origin
};

// What a look at the files found and did.
struct Reload {
  std::vector<std::string> changed;   // files, as people know them
  bool swapped = false;               // a new version runs
  std::vector<std::string> problems;  // what keeps (parts of) the newest files from running, each with its place
  std::vector<std::string> kept;      // values and histories that live on: "samples = 8", "history sum.mean"
  std::vector<std::string> reset;     // those that do not, and why
  std::vector<std::string> rebuilt;   // nodes that run a new pipeline
  int compilations = 0;               // pipelines compiled
  double notice_ms = 0;               // hashing the files to see which changed
  double evaluate_ms = 0;             // Lua, in its process
  double compile_ms = 0;              // GLSL to pipelines
  double build_ms = 0;                // plan, images, descriptor sets
};

// For the terminal: what was taken or refused, why, what was kept and what was reset; one line each.
std::string textOf(const Reload& reload);

class Session {
 public:
  // Loads, plans and compiles; throws `Error` where that fails. `origin` says who set the values of the shot.
  // The bench must outlive it.
  Session(Workbench& bench, const Shot& shot, const std::string& origin = "command line");
  ~Session();

  Workbench& bench() const;
  const Shot& shot() const;        // as it stands: what a record or a command line would say
  const plan::Plan& plan() const;  // of the running version
  const scene::Scene& scene() const;
  graph::Backend backend() const;
  // Identity of what runs: independent of taps and of what is looked at.
  std::string planHash() const;
  // What the nodes execute, by name.
  std::map<std::string, std::shared_ptr<const graph::NodePipeline>> pipelines() const;
  // Every value that can be changed, the shot's first, then the pipeline's, then the nodes' own.
  std::vector<Control> controls() const;
  // What keeps the newest files from running; empty while all of them run.
  const std::vector<std::string>& problems() const;

  // Changes a value: an option of the shot, PARAM of the pipeline, NODE.PARAM or scene.PARAM; a text serves as the
  // value it reads as. Throws `Error` (unknown name with the nearest, wrong value, a graph that cannot be built); then
  // nothing changed.
  void set(const std::string& name, const plan::Value& value, const std::string& origin);
  // Gives the value back to preset, scene or default.
  void unset(const std::string& name);
  // Runs another pipeline; values whose names and types it shares are kept, as in a reload.
  Reload usePipeline(const std::string& name_or_path);
  // Keeps these "node.port" images readable as well; changes no result. Unknown names throw.
  void tap(const std::vector<std::string>& ports);
  // Every "node.port" the plan holds, in order of execution.
  std::vector<std::string> ports() const;

  // Looks whether files changed and brings what is sound up to date. Without `wait`, Lua is evaluated in the
  // background: nothing is returned until a later call finds it done, on the values as they are then. Nothing is
  // returned when nothing changed. Never throws for what users write.
  std::optional<Reload> reload(bool wait);

  // Draws the frame as it stands, reading back the outputs ("color") and taps ("node.port") named; null: all.
  graph::FrameResult draw(const std::set<std::string>* outputs = nullptr,
                          const std::function<void(int done, int of)>& progress = {});
  // The limits that a frame met as it was drawn, a line each: its shot's, then its passes'.
  std::vector<std::string> limitsMet(const graph::FrameResult& frame) const;
  // The frame with sub-pixel samples, run record and timings: what `strobe render` writes.
  Picture capture(const std::function<void(int done, int of)>& progress = {});

 private:
  struct Changes;  // which of the files differ from what was last tried
  struct Pending;  // an evaluation in the background

  void evaluateInBackground(Changes changes);
  std::unique_ptr<Drawing> build(const Shot& shot, std::shared_ptr<const Evaluation> evaluation,
                                 std::vector<std::string>* problems);
  void reloadScene(Shot& shot, std::vector<std::string>& problems);
  std::shared_ptr<const Evaluation> evaluationOf(const Shot& shot) const;
  void apply(const Shot& shot);
  void take(const ShotOption& option, const Shot& shot);
  Reload replace(Shot shot, Attempt evaluated, Changes changes);
  Changes lookAtFiles();
  void rememberFiles(const std::vector<script::Dependency>& tried);
  bool watchFolders();

  Workbench& bench_;
  Shot shot_;
  std::string given_by_;
  std::map<std::string, std::string> origins_;  // of settings and options, by name
  std::unique_ptr<Drawing> running_;
  std::vector<std::string> problems_;
  bool script_problem_ = false;  // one of them is Lua's: evaluated again at the next change of any file
  WatchedFiles files_;
  std::unique_ptr<Pending> pending_;
};

}  // namespace strobe::lab
