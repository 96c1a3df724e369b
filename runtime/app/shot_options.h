// SPDX-License-Identifier: MIT
// Options shared by all commands that take a picture, each with one spelling.
#pragma once

#include <CLI/CLI.hpp>
#include <set>

#include "gpu/device.h"
#include "lab/shot_options.h"

namespace strobe::app {

// Shot options of a command line, as text until `resolve`.
struct ShotOptions {
  std::string pipeline, shading, record;
  std::vector<std::string> sets;
  int samples = 0;

  // Options in `several` may be given more than once: `given` returns all texts, `resolve` uses the last.
  void addTo(CLI::App& command, const std::set<std::string>& several = {});
  // Like addTo, with the pipeline as first argument and `--record FILE`, a run record. The record's shot replaces the
  // defaults. Options given beside the record win.
  void addWithPipeline(CLI::App& command);
  // Throws `Error` with exit code 2 if a text does not parse, or if the pipeline is missing.
  lab::Shot resolve() const;
  // Texts of an option; empty if the option was not given.
  std::vector<std::string> given(const std::string& option) const;
  // Given options as arguments of a command line, without the pipeline and without the options in `without`.
  std::vector<std::string> words(const std::set<std::string>& without) const;

 private:
  std::map<std::string, std::vector<std::string>> given_;  // texts by option
};

// `--tev [HOST:PORT]`: sets `address` to the text, or to the viewer's default port if the text is empty. Without the
// option, `address` stays "".
void addTev(CLI::App& command, std::string& address);

// `--time-limit S`: seconds of work on the device after which the program ends (gpu::Device::setTimeLimit).
void addTimeLimit(CLI::App& command, double& seconds);

// `--budget-ms B`: largest frame time, milliseconds; 0: no budget. Chooses the pipeline parameter with the role
// Quality.
void addBudget(CLI::App& command, double& ms);

// True if the environment variable STROBE_VALIDATION is set, not empty and not 0.
bool validationWanted();

}  // namespace strobe::app
