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

#include "lab/controls.h"
#include "lab/file_changes.h"

namespace strobe::lab {

// What a look at the files found and did.
struct Reload {
  std::vector<std::string> changed;   // files, as people know them
  bool swapped = false;               // a new version runs
  std::vector<std::string> problems;  // what keeps (parts of) the newest files from running, each with its place
  std::vector<std::string> kept;      // values and histories that live on: "samples = 8", "history sum.mean"
  std::vector<std::string> reset;     // those that do not, and why
  std::vector<std::string> choices;   // that came: "edge = dilation"
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

  Workbench& bench() const { return bench_; }
  const Shot& shot() const { return shot_; }  // as it stands: what a record or a command line would say
  const Drawing& running() const { return *running_; }
  const plan::Plan& plan() const { return running_->plan(); }
  const scene::Scene& scene() const { return running_->scene().scene; }
  // Every value that can be changed.
  std::vector<Control> controls() const { return controlsOf(shot_, *running_, origins_, given_by_); }
  // What keeps the newest files from running; empty while all of them run.
  const std::vector<std::string>& problems() const { return problems_; }

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
  // Every "node.port" the plan holds, in order of execution, then those of nodes that the frame does not require.
  std::vector<std::string> ports() const;

  // Looks whether files changed and brings what is sound up to date. Without `wait`, Lua is evaluated in the
  // background: nothing is returned until a later call finds it done, on the values as they are then; and what fails
  // is tried again if a file changes within a tenth of a second, and takes effect and is returned after that. Nothing
  // is returned when nothing changed. Never throws for what users write.
  std::optional<Reload> reload(bool wait);
  // True if a later call may return a change of now.
  bool evaluates() const { return files_.evaluates(); }

  // Draws the frame as it stands, reading back the outputs ("color") and taps ("node.port") named; null: all.
  // `progress` (may be empty) is called after each iteration of a loop; what it throws ends the frame.
  graph::FrameResult draw(const std::set<std::string>* outputs = nullptr,
                          const std::function<void(int done, int of)>& progress = {}) {
    graph::FrameResult frame = running_->draw(shot_, outputs, progress);
    replaced_.reset();
    return frame;
  }
  // The limits that a frame met as it was drawn, a line each: its shot's, then its passes'.
  std::vector<std::string> limitsMet(const graph::FrameResult& frame) const {
    return running_->limitsMet(shot_, frame);
  }
  // The frame with sub-pixel samples, run record and timings: what `strobe render` writes.
  Picture capture(const std::function<void(int done, int of)>& progress = {}, bool id_coverage = false) {
    return running_->capture(shot_, nullptr, progress, id_coverage);
  }

 private:
  std::unique_ptr<Drawing> build(const Shot& shot, std::shared_ptr<const Evaluation> evaluation,
                                 std::vector<std::string>* problems, bool whole = false);
  std::shared_ptr<const Evaluation> evaluationOf(const Shot& shot) const;
  void apply(const Shot& shot);
  void drop(const std::vector<script::DroppedSetting>& dropped, Shot& shot, Reload& result);
  void replace(Shot shot, const std::shared_ptr<const Evaluation>& evaluation, bool scene, bool whole, Reload& result);

  Workbench& bench_;
  Shot shot_;
  std::string given_by_;
  std::map<std::string, std::string> origins_;  // of settings and options, by name
  std::unique_ptr<Drawing> running_;
  std::unique_ptr<Drawing> replaced_;  // ends after the first picture of what runs: that comes first
  std::vector<std::string> problems_;
  bool script_problem_ = false;  // one of them is Lua's: evaluated again at the next change of any file
  ChangedFiles files_;
};

}  // namespace strobe::lab
