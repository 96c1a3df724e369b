// SPDX-License-Identifier: MIT
// What the scripts of a pipeline give with some settings, and how to go on where the newest of them fail.
#pragma once

#include <map>
#include <memory>

#include "base/stamps.h"
#include "lab/shot.h"

namespace strobe::lab {

struct Evaluation {
  plan::PipelineDesc pipeline;
  std::vector<script::Dependency> scripts;                  // that were read
  script::Texts texts;                                      // of the scripts, where files still hold them
  std::shared_ptr<const script::Described> described = {};  // for the next evaluation
};

// Throws `Error`, with the places of the user's lines.
Evaluation evaluated(const Home& home, const std::string& pipeline, const script::Settings& sets,
                     const script::Limits& limits);

// Evaluations of the same pipelines with many settings, each as `evaluated` gives it: all but the first of a pipeline
// fork from a process that has loaded its scripts, as long as none of these changes and no file comes beside them.
// Not thread-safe.
class Evaluator {
 public:
  // Both must outlive it.
  Evaluator(const Home& home, const script::Limits& limits) : home_(home), limits_(limits) {}
  Evaluation evaluate(const std::string& pipeline, const script::Settings& sets);

 private:
  // Of a pipeline, when it was evaluated first.
  struct Loaded {
    Stamps files;
    script::Texts texts;
  };

  const Home& home_;
  const script::Limits& limits_;
  std::map<std::string, Loaded> loaded_;
  script::Limits within_;  // those of `evaluator_`
  std::unique_ptr<script::PipelineEvaluator> evaluator_;
};

// Whether files still hold what they held when they were evaluated.
bool isCurrent(const std::vector<script::Dependency>& files);
Stamps stampsOf(const std::vector<script::Dependency>& files);

// An evaluation that may have failed; the following two never throw.
struct Attempt {
  Evaluation good;                          // after a failure, the scripts it read until then
  std::vector<script::Dependency> refused;  // newest files that failed, where older texts took their place
  std::vector<script::DroppedSetting> dropped;
  std::vector<std::string> problems;
  bool usable = false;
  double ms = 0;
};

// With these texts in the place of what their files hold now. `lenient`: settings that do not fit are dropped.
// `before`: an earlier evaluation, which saves reading files that say still what they said.
Attempt attempt(const Home& home, const Shot& shot, const script::Texts& texts, const script::Limits& limits,
                bool lenient, const Evaluation& before = {});

// The newest files; where they fail, as many of them as work: files are put back to their last text that was `good`,
// those an error names first. Lenient.
Attempt attemptAround(const Home& home, const Shot& shot, const Evaluation& good, const script::Limits& limits);

}  // namespace strobe::lab
