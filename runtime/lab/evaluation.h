// SPDX-License-Identifier: MIT
// Evaluation of a pipeline's scripts with settings, and recovery if the newest scripts fail.
#pragma once

#include <map>
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
  std::shared_ptr<const script::Described> described = {};  // input of the next evaluation
};

// Evaluates a pipeline. Throws `Error` with the places of the user's lines.
Evaluation evaluated(const Home& home, const std::string& pipeline, const script::Settings& sets,
                     const script::Limits& limits);

// Evaluates the same pipelines with many settings, with the results of `evaluated`. The first evaluation of a pipeline
// loads its scripts; later evaluations fork from a process that has loaded them, until a script changes or a file
// appears beside them. Not thread-safe.
class Evaluator {
 public:
  // Both arguments must outlive the evaluator.
  Evaluator(const Home& home, const script::Limits& limits) : home_(home), limits_(limits) {}
  Evaluation evaluate(const std::string& pipeline, const script::Settings& sets);

 private:
  // Files and texts of a pipeline at its first evaluation.
  struct Loaded {
    Stamps files;
    script::Texts texts;
  };

  const Home& home_;
  const script::Limits& limits_;
  std::map<std::string, Loaded> loaded_;
  script::Limits within_;  // limits of `evaluator_`
  std::unique_ptr<script::PipelineEvaluator> evaluator_;
};

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

// Evaluates with `texts` instead of the contents of their files. `lenient`: drops settings that do not fit. `before`:
// an earlier evaluation, reused for unchanged files.
Attempt attempt(const Home& home, const Shot& shot, const script::Texts& texts, const script::Limits& limits,
                bool lenient, const Evaluation& before = {});

// Evaluates the newest files. If they fail, changed files are replaced by their text in `good` until the evaluation
// works, starting with the files that the error names. Lenient.
Attempt attemptAround(const Home& home, const Shot& shot, const Evaluation& good, const script::Limits& limits);

}  // namespace strobe::lab
