// SPDX-License-Identifier: MIT
// What the scripts of a pipeline give with some settings, and how to go on where the newest of them fail.
#pragma once

#include "lab/shot.h"

namespace strobe::lab {

struct Evaluation {
  plan::PipelineDesc pipeline;
  std::vector<script::Dependency> scripts;  // that were read
  script::Texts texts;                      // of the scripts, where files still hold them
};

// Throws `Error`, with the places of the user's lines.
Evaluation evaluated(const Home& home, const std::string& pipeline, const script::Settings& sets,
                     const script::Limits& limits);

// An evaluation that may have failed; the following two never throw.
struct Attempt {
  Evaluation good;                          // after a failure, the scripts it read until then
  std::vector<script::Dependency> refused;  // newest files that failed, where older texts took their place
  std::vector<script::DroppedSetting> dropped;
  std::vector<std::string> problems;
  bool usable = false;
  double ms = 0;
};

// With these texts in the place of what their files hold now. `lenient`: settings that do not fit are dropped. `known`:
// what files said earlier, which saves reading those that say it still.
Attempt attempt(const Home& home, const Shot& shot, const script::Texts& texts, const script::Limits& limits,
                bool lenient, const script::Texts& known = {});

// The newest files; where they fail, as many of them as work: files are put back to their last `good` text, those an
// error names first. Lenient.
Attempt attemptAround(const Home& home, const Shot& shot, const script::Texts& good, const script::Limits& limits);

}  // namespace strobe::lab
