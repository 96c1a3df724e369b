// SPDX-License-Identifier: MIT
#include "live/live.h"

#include <memory>

#include "app/commands.h"
#include "app/shot_options.h"

namespace strobe::app {

namespace {

struct LiveCommandOptions {
  ShotOptions shot;
  std::string versus, truth, out = "out/live", window = "1400x900", drive, tev;
  std::vector<std::string> versus_sets;
  double time_limit_s = 10, budget_ms = 0;
};

// Throws `Error` for a pipeline that cannot run, before a window opens.
void checkPipelines(const Home& home, const live::DeskOptions& desk) {
  plan::PipelineDesc pipeline = script::evaluatePipeline(home, {desk.shot.pipeline, desk.shot.sets});
  if (desk.budget_ms > 0) lab::budgetedParam(pipeline);
  if (!desk.versus.empty()) script::evaluatePipeline(home, {desk.versus, desk.versus_sets});
}

void live(const Home& home, const LiveCommandOptions& options) {
  live::LiveOptions wanted;
  wanted.desk.shot = options.shot.resolve();
  wanted.desk.versus = options.versus;
  for (const std::string& set : options.versus_sets)
    wanted.desk.versus_sets.push_back(script::settingFromText(set, "--vs-set"));
  if (options.versus.empty() && !options.versus_sets.empty()) throw Error("--vs-set needs --vs", {}, 2);
  wanted.desk.truth = options.truth;
  wanted.desk.out = options.out;
  wanted.desk.budget_ms = options.budget_ms;
  auto [width, height] = lab::parseSize(options.window, "--window");
  wanted.width = width;
  wanted.height = height;
  wanted.size_given = wanted.desk.shot.width != 0;
  wanted.drive = options.drive;
  if (!options.tev.empty()) wanted.tev = lab::parseTevAddress(options.tev);
  wanted.time_limit_s = options.time_limit_s;
  wanted.validation = validationWanted();
  checkPipelines(home, wanted.desk);
  live::runLive(home, wanted);
}

}  // namespace

void registerLive(CLI::App& program, const Home& home) {
  auto options = std::make_shared<LiveCommandOptions>();
  CLI::App* command =
      program.add_subcommand("live", "Show a pipeline in a window; edited scripts and shaders are reloaded");
  options->shot.addWithPipeline(*command);
  command->add_option("--vs", options->versus, "a second pipeline to compare with, under the same clock and camera");
  command
      ->add_option("--vs-set", options->versus_sets, "PARAM=VALUE of the pipeline of --vs, NODE.PARAM=VALUE of a pass")
      ->allow_extra_args(false);
  command->add_option("--truth", options->truth,
                      "the pipeline that errors are measured against (default: the pipeline with kind = \"truth\")");
  command->add_option("--window", options->window, "WIDTHxHEIGHT of the window in pixels")->capture_default_str();
  command->add_option("-o,--out", options->out, "folder for saved files")->capture_default_str();
  command->add_option("--drive", options->drive, "a file of commands that drives the window");
  addBudget(*command, options->budget_ms);
  addTimeLimit(*command, options->time_limit_s);
  addTev(*command, options->tev);
  command->callback([options, &home] { live(home, *options); });
}

}  // namespace strobe::app
