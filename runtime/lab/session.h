// SPDX-License-Identifier: MIT
// A persistent shot. Its values can be changed and its files edited while it is drawn. Every change is a transaction:
// the new version is evaluated, compiled and planned beside the running version, and replaces it when it is valid.
// After a reload, an invalid part keeps its last valid version. The window, captures and tests use sessions.
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

// Result of a check for changed files.
struct Reload {
  std::vector<std::string> changed;   // changed files, for display
  bool swapped = false;               // true if a new version runs
  std::vector<std::string> problems;  // errors in the newest files, each with its place
  std::vector<std::string> kept;      // kept values and histories: "samples = 8", "history sum.mean"
  std::vector<std::string> reset;     // lost values and histories, each with the reason
  std::vector<std::string> choices;   // new choices: "edge = dilation"
  std::vector<std::string> rebuilt;   // nodes that run a new pipeline
  int compilations = 0;               // number of compiled pipelines
  double evaluate_ms = 0;             // time of Lua in its process
  double compile_ms = 0;              // time from GLSL to pipelines
  double build_ms = 0;                // time for plan, images and descriptor sets
};

// Terminal text: version taken or refused, problems, kept and reset values, one line each.
std::string textOf(const Reload& reload);

// Interactive rendering of one shot, with values that can be changed and files that are reloaded between frames. An
// invalid change leaves the last valid version running.
class Session {
 public:
  // Loads, plans and compiles. Throws `Error` on failure. `origin`: source of the values in the shot. The bench must
  // outlive the session.
  Session(Workbench& bench, const Shot& shot, const std::string& origin = "command line");

  Workbench& bench() const { return bench_; }
  const Shot& shot() const { return shot_; }  // present shot, as for a record or a command line
  const Drawing& running() const { return *running_; }
  const plan::Plan& plan() const { return running_->plan(); }
  const scene::Scene& scene() const { return running_->scene().scene; }
  // All values that can be changed.
  std::vector<Control> controls() const { return controlsOf(shot_, *running_, origins_, given_by_); }
  // Errors in the newest files; empty without errors.
  const std::vector<std::string>& problems() const { return problems_; }

  // Changes a value: an option of the shot, PARAM of the pipeline, NODE.PARAM or scene.PARAM. A text is converted to a
  // value. Throws `Error` for an unknown name (with the nearest name), a wrong value, or a graph that cannot be built;
  // nothing changes then.
  void set(const std::string& name, const plan::Value& value, const std::string& origin);
  // Resets a value to the preset, the scene or the default.
  void unset(const std::string& name);
  // Runs another pipeline. Keeps values with the same name and type, as in a reload.
  Reload usePipeline(const std::string& name_or_path);
  // Makes the images "node.port" readable instead of the previous taps. Results do not change. Throws `Error` for
  // unknown names.
  void tap(const std::vector<std::string>& ports);
  // Every "node.port" of the plan in execution order, then the ports of nodes that the frame does not require.
  std::vector<std::string> ports() const;

  // Checks the files for changes and runs the valid parts of the new version. Without `wait`, Lua is evaluated in the
  // background, and a later call returns the result for the values at that time. A failure takes effect and is returned
  // after 0.1 s, unless a file changes before. Empty if nothing changed. Never throws for errors in user files.
  std::optional<Reload> reload(bool wait);
  // True if a later call to `reload` may return a change that has already happened.
  bool evaluates() const { return files_.evaluates(); }

  // Draws the present frame. Reads back the named outputs ("color") and taps ("node.port"); null: all. `progress` (may
  // be empty) is called after each iteration of a loop. An exception from it ends the frame.
  graph::FrameResult draw(const std::set<std::string>* outputs = nullptr,
                          const std::function<void(int done, int of)>& progress = {}) {
    graph::FrameResult frame = running_->draw(shot_, outputs, progress);
    replaced_.reset();
    return frame;
  }
  // Warnings about the limits that a drawn frame met, one line each: shot limits first, then pass limits.
  std::vector<LimitMet> limitsMet(const graph::FrameResult& frame) const { return running_->limitsMet(shot_, frame); }
  // The frame with sub-pixel samples, run record and timings, as written by `strobe render`.
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
  std::map<std::string, std::string> origins_;  // origin of settings and options, by name
  std::unique_ptr<Drawing> running_;
  std::unique_ptr<Drawing> replaced_;  // destroyed after the first picture of `running_`
  std::vector<std::string> problems_;
  bool script_problem_ = false;  // one problem is in Lua: evaluate again at the next change of any file
  ChangedFiles files_;
};

}  // namespace strobe::lab
