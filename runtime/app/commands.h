// SPDX-License-Identifier: MIT
// Commands of the program. Each function adds one command to the command line. The callback of a command runs while the
// command line is parsed, and throws `Error`.
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

void registerRender(CLI::App& program, const Home& home);   // one picture
void registerLive(CLI::App& program, const Home& home);     // a pipeline in a window
void registerCompare(CLI::App& program);                    // error metrics of two images
void registerCapture(CLI::App& program, const Home& home);  // `capture`, `verify`, `diff`: reproducible pictures
void registerDemo(CLI::App& program, const Home& home);     // a capture, measured

void registerSweep(CLI::App& program, const Home& home);      // an experiment
void registerReport(CLI::App& program, const Home& home);     // report of an experiment's results
void registerTune(CLI::App& program, const Home& home);       // best setting of a pipeline, as a preset
void registerBench(CLI::App& program, const Home& home);      // `bench` with `reload`, `frames` and `slopes`
void registerBenchFrames(CLI::App& bench, const Home& home);  // frame time of each method
void registerBenchSlopes(CLI::App& bench, const Home& home);  // growth of the frame time along one axis at a time
void registerStability(CLI::App& program, const Home& home);  // invariants and extreme cases

// Checks of scripts, graphs and the machine, without drawing.
void registerCheck(CLI::App& program, const Home& home);
void registerPlan(CLI::App& program, const Home& home);
void registerDoctor(CLI::App& program, const Home& home);

void registerHelp(CLI::App& program, const Home& home);        // reference page of a pass, pipeline or parameter
void registerNew(CLI::App& program, const Home& home);         // a new project
void registerCompletion(CLI::App& program, const Home& home);  // `complete`: completions, for completion.bash

}  // namespace strobe::app
