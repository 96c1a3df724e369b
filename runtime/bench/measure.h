// SPDX-License-Identifier: MIT
// Measures frame times.
#pragma once

#include <functional>

#include "bench/times.h"
#include "lab/batch.h"
#include "lab/shot_data.h"
#include "plan/traffic.h"

namespace strobe::bench {

// Arm from "PIPELINE", or from "PIPELINE:preset=fast,samples=32"; the text is the arm's name. The settings after the
// first ':' are NAME=VALUE, separated by ','. Throws `Error` (exit code 2) if the text has another form. Does not check
// that the pipeline has the settings.
lab::Arm methodFrom(const std::string& text);

// Shots of a run: every method on every scene at every size. All other options are as in `shot`. No list is empty.
struct Subject {
  std::vector<std::string> scenes;
  std::vector<std::array<int, 2>> sizes;
  std::vector<lab::Arm> methods;
  lab::Shot shot;
};

// A timed shot, and the names of its scene and method in the run.
struct NamedShot {
  std::string scene, method;
  lab::Shot shot;
};

std::vector<NamedShot> shotsOf(const Subject& subject);

// Run without times: the shots with the suggestions of their scenes, the device and the program. `shots` is not empty.
// Throws `Error`, with exit code 2 if a method does not accept its settings.
Run outlineOf(lab::Workbench& bench, const std::vector<NamedShot>& shots);

// Traffic of one execution of each pass of a plan, by node name. A timed frame may run fewer passes.
std::map<std::string, plan::Traffic> trafficByPass(const plan::Plan& plan);

// Draws one frame of every shot per round. `shots` is not empty.
Run measure(lab::Workbench& bench, const std::vector<NamedShot>& shots, const lab::Rounds& rounds);

// Benchmark runs of two programs that ran alternately in one session, one run per block and program.
struct Turns {
  std::vector<Run> first, second;  // one run per block and program
};

// Runs each of two programs `blocks` times. `arguments` make a program print a run as JSON. The first program to run
// alternates from block to block, so that a drift of the machine's speed favours neither. `progress` is called after
// each block of both. Throws `Error` with a program's message if the program fails or prints anything but a run, and if
// the two runs have different shots.
Turns runInTurn(const std::string& first, const std::string& second, const std::vector<std::string>& arguments,
                int blocks, const std::function<void(int done)>& progress);

}  // namespace strobe::bench
