// SPDX-License-Identifier: MIT
// Draws the frames that are timed.
#pragma once

#include "bench/times.h"
#include "lab/batch.h"
#include "plan/traffic.h"

namespace strobe::bench {

// A pipeline with settings of its own: "PIPELINE", or "PIPELINE:preset=fast,samples=32". Text behind the first ':' is
// NAME=VALUE with ',' between them.
struct Method {
  std::string text;  // as it was given: what it is called
  std::string pipeline;
  script::Settings sets;
};
// Throws `Error` (exit code 2) for what is not written so. Whether the pipeline has the settings is not looked at.
Method methodFrom(const std::string& text);

// What a run is of: every method on every scene at every size, all else as in `shot`. No list is empty.
struct Subject {
  std::vector<std::string> scenes;
  std::vector<std::array<int, 2>> sizes;
  std::vector<Method> methods;
  lab::Shot shot;
};

// A frame that is timed, and what it goes by in the run.
struct NamedShot {
  std::string scene, method;
  lab::Shot shot;
};

// The run without times: its shots with what scenes suggest, device and program. Throws `Error`, with exit code 2 where
// a method does not take its settings.
Run outlineOf(lab::Workbench& bench, const Subject& subject);

// What an execution of each pass of a plan touches, by the node's name. A frame that is timed may run fewer of them.
std::map<std::string, plan::Traffic> trafficByPass(const plan::Plan& plan);

// The run: a frame of every shot in turn, round after round. There is a shot at least.
Run measure(lab::Workbench& bench, const std::vector<NamedShot>& shots, const lab::Rounds& rounds);
Run measure(lab::Workbench& bench, const Subject& subject, const lab::Rounds& rounds);

}  // namespace strobe::bench
