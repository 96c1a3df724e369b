// SPDX-License-Identifier: MIT
// Commands of the program. Each function adds a command to the command line; the command runs, and throws `Error`,
// while the command line is parsed.
#pragma once

#include <CLI/CLI.hpp>

#include "app/kept_bench.h"
#include "base/home.h"

namespace strobe::app {

void registerDemo(CLI::App& program, const Home& home);                      // takes a capture and measures it
void registerRender(CLI::App& program, const Home& home, KeptBench& bench);  // one picture
void registerServe(CLI::App& program, const Home& home, KeptBench& bench);   // commands from standard input
void registerHelp(CLI::App& program, const Home& home);       // reference page of a pass, a pipeline or a parameter
void registerLive(CLI::App& program, const Home& home);       // shows a pipeline in a window
void registerCheck(CLI::App& program, const Home& home);      // checks scripts, without drawing
void registerPlan(CLI::App& program, const Home& home);       // prints the plan of a graph, without drawing
void registerCompare(CLI::App& program);                      // error metrics of two images
void registerSweep(CLI::App& program, const Home& home);      // runs an experiment
void registerReport(CLI::App& program, const Home& home);     // lays out the results of an experiment again
void registerStatus(CLI::App& program);                       // progress of a sweep, and the programs that draw it
void registerTune(CLI::App& program, const Home& home);       // best setting of a pipeline, as a preset
void registerCapture(CLI::App& program, const Home& home);    // `capture`, `verify`, `diff`: pictures to repeat exactly
void registerBench(CLI::App& program, const Home& home);      // `bench` with `reload`, `frames` and `slopes`
void registerStability(CLI::App& program, const Home& home);  // checks invariants on generated scenes
void registerNew(CLI::App& program, const Home& home);        // makes a project
void registerDoctor(CLI::App& program, const Home& home);     // lists devices and missing requirements
void registerCompletion(CLI::App& program, const Home& home);  // completions of a command line, for completion.bash

// Commands of `bench` (docs/benchmarks.md): frame time of each method, and growth of the frame time along one axis at a
// time.
void registerBenchFrames(CLI::App& bench, const Home& home);
void registerBenchSlopes(CLI::App& bench, const Home& home);

}  // namespace strobe::app
