// SPDX-License-Identifier: MIT
// Evaluation of a pipeline's scripts with settings, and recovery if the newest scripts fail.
#pragma once

#include <functional>
#include <memory>

#include "base/stamps.h"
#include "lab/shot.h"

namespace strobe::lab {

// Result of a pipeline's Lua scripts with given settings: the description of the pipeline, and the files and script
// texts behind it.
struct Evaluation {
  plan::PipelineDesc pipeline;
  std::vector<script::Dependency> scripts;  // files and folders that the evaluation read
  script::Texts texts;                      // texts of the scripts, for files that have not changed since
};

// Evaluates a pipeline. Throws `Error` with the places of the user's lines. `known`: texts of earlier evaluations, to
// read fewer files.
Evaluation evaluated(const Home& home, const std::string& pipeline, const script::Settings& sets,
                     const script::Limits& limits, const script::Texts& known = {});

// Evaluation with `sets`, derived from an evaluation with the settings that decide the graph: the other settings change
// only numbers. `by_scripts` runs the scripts with the deciding settings, and returns null if one is refused. Null if a
// setting is refused; running the scripts with all settings then gives the message.
using ByScripts = std::function<std::shared_ptr<const Evaluation>(const script::Settings& deciding)>;
std::shared_ptr<const Evaluation> derivedEvaluation(const script::Settings& sets, const ByScripts& by_scripts);

// True if the content of all files is unchanged since the evaluation.
bool isCurrent(const std::vector<script::Dependency>& files);
Stamps stampsOf(const std::vector<script::Dependency>& files);

// An evaluation that may have failed. `attempt` and `attemptAround` never throw.
struct Attempt {
  Evaluation good;                          // after a failure: the scripts read before it
  std::vector<script::Dependency> refused;  // newest files that failed and were replaced by older texts
  std::vector<script::DroppedSetting> dropped;
  std::vector<std::string> problems;
  bool usable = false;
  double ms = 0;
};

// Evaluates with `texts` instead of the contents of their files. `lenient`: drops settings that do not fit. `known`:
// see `evaluated`.
Attempt attempt(const Home& home, const Shot& shot, const script::Texts& texts, const script::Limits& limits,
                bool lenient, const script::Texts& known = {});

// Evaluates the newest files. If they fail, changed files are replaced by their text in `good` until the evaluation
// works, starting with the files that the error names. Lenient.
Attempt attemptAround(const Home& home, const Shot& shot, const Evaluation& good, const script::Limits& limits);

}  // namespace strobe::lab
