// SPDX-License-Identifier: MIT
#include "app/bench.h"

#include <cstdio>
#include <memory>

#include "app/shot_options.h"
#include "base/log.h"
#include "image/comparison.h"
#include "lab/reload_bench.h"
#include "lab/value_bench.h"

namespace strobe::app {

namespace {

struct Options {
  ShotOptions shot;
  int repeats = 15;
  bool json = false;
  std::vector<std::string> tries;
  std::string against;
};

void reload(const Options& options) {
  lab::Shot shot = options.shot.resolve();
  if (shot.width == 0) shot.width = 160, shot.height = 90;
  lab::Workbench bench(shot.device, validationWanted());
  std::vector<lab::ReloadTiming> timings = lab::benchReload(bench, shot, options.repeats);
  if (options.json) {
    Json json;
    json["device"] = bench.device().info().name;
    json["shot"] = lab::toJson(shot);
    for (const auto& t : timings)
      json["reload"].push_back({{"edited", t.edit}, {"watch_ms", t.watch}, {"evaluate_ms", t.evaluate},
                                {"compile_ms", t.compile}, {"build_ms", t.build}, {"first_frame_ms", t.first_frame},
                                {"later_frame_ms", t.later_frame}, {"added_ms", t.added()}});
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("%s at %dx%d on %s, milliseconds, medians of %d\n\n%s", shot.pipeline.c_str(), shot.width, shot.height,
              bench.device().info().name.c_str(), options.repeats, lab::tableOf(timings).c_str());
}

void values(const Options& options) {
  lab::Shot shot = options.shot.resolve();
  lab::Workbench bench(shot.device, validationWanted());
  bench.scene(shot);
  image::Image reference;
  if (!options.against.empty()) reference = image::readPicture(options.against, "").linear;
  bool fits = options.against.empty() || (reference.width == shot.width && reference.height == shot.height);
  if (!fits)
    throw Error(fmt::format("{} is not a picture of {}x{} pixels", options.against, shot.width, shot.height), {}, 2);
  std::vector<lab::ValueCost> costs = lab::benchValues(bench, shot, options.tries, options.repeats, reference);
  refuseMessages(bench.device());
  const std::string& device = bench.device().info().name;
  if (options.json) {
    Json json = {{"device", device}, {"shot", lab::toJson(shot)}, {"values", lab::jsonOf(costs)}};
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("%s at %dx%d on %s, times are medians of %d frames drawn in turns\n\n%s\n", shot.pipeline.c_str(),
              shot.width, shot.height, device.c_str(), options.repeats, lab::tableOf(costs).c_str());
}

}  // namespace

void registerBench(CLI::App& program) {
  CLI::App* command = program.add_subcommand("bench", "Measure what the program itself costs");
  command->require_subcommand(1);
  auto options = std::make_shared<Options>();
  CLI::App* of_reload = command->add_subcommand("reload", "From saving a file to the first picture made of it");
  of_reload->add_option("--repeats", options->repeats, "edits of each kind")->check(CLI::Range(1, 1000))->capture_default_str();
  of_reload->add_flag("--json", options->json, "report as JSON");
  options->shot.addWithPipeline(*of_reload);
  of_reload->callback([options] { reload(*options); });

  auto tried = std::make_shared<Options>();
  const char* what = "What values of parameters change in the picture, and their cost";
  CLI::App* of_values = command->add_subcommand("values", what);
  of_values->add_option("--try", tried->tries, "NAME=VALUE[,NAME=VALUE...] to draw instead of the shot as it is")
      ->required()->allow_extra_args(false);
  of_values->add_option("--against", tried->against, "a picture (of truth, say): tell each one's distance from it")
      ->type_name("FILE");
  of_values->add_option("--repeats", tried->repeats, "frames of each")
      ->check(CLI::Range(1, 1000))->capture_default_str();
  of_values->add_flag("--json", tried->json, "report as JSON");
  tried->shot.addWithPipeline(*of_values);
  of_values->callback([tried] { values(*tried); });
}

}  // namespace strobe::app
