// SPDX-License-Identifier: MIT
// The options that every command taking a picture shares: one spelling each.
#pragma once

#include <CLI/CLI.hpp>
#include <set>

#include "gpu/device.h"
#include "lab/shot_options.h"

namespace strobe::app {

// What a command line says of a shot, as text until `resolve`.
struct ShotOptions {
  std::string pipeline, shading, record;
  std::vector<std::string> sets;
  int samples = 0;

  // Those of `several` may be given more than once: `given` has all, `resolve` takes the last.
  void addTo(CLI::App& command, const std::set<std::string>& several = {});
  // The same with the pipeline as first argument, and `--record FILE`, a run record whose shot is taken instead of the
  // defaults: what is given beside it wins.
  void addWithPipeline(CLI::App& command);
  // Throws `Error` with exit code 2 for text that does not parse, or without a pipeline.
  lab::Shot resolve() const;
  // The texts of an option, none where it was not given.
  std::vector<std::string> given(const std::string& option) const;
  // What was given, as words of a command line, without the pipeline and these options.
  std::vector<std::string> words(const std::set<std::string>& without) const;

 private:
  std::map<std::string, std::vector<std::string>> given_;  // texts by option
};

// `--tev [HOST:PORT]`: leaves "" in `address` when it is not given, what was given or the viewer's own port otherwise.
void addTev(CLI::App& command, std::string& address);

// `--time-limit S`: after how long work on the device ends the program (gpu::Device::setTimeLimit).
void addTimeLimit(CLI::App& command, double& seconds);

// `--budget-ms B`: longest time of a frame, which the pipeline's parameter of the role Quality is set for; 0: none.
void addBudget(CLI::App& command, double& ms);

// Validation is on when STROBE_VALIDATION is set to anything but 0.
bool validationWanted();

}  // namespace strobe::app
