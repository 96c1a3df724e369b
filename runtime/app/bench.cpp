// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/shot_options.h"
#include "base/frozen_home.h"
#include "lab/reload_bench.h"

namespace strobe::app {

namespace {

struct ReloadOptions {
  ShotOptions shot;
  int repeats = 15;
  bool json = false;
};

void reload(const Home& own, const ReloadOptions& options) {
  lab::Shot shot = options.shot.resolve();
  if (shot.width == 0) shot.width = 160, shot.height = 90;
  FrozenHome copy(own, std::filesystem::temp_directory_path() / fmt::format("strobe_bench_{}", ::getpid()));
  if (shot.pipeline.ends_with(".lua")) shot.pipeline = copy.at(shot.pipeline);
  lab::Workbench bench(copy.home(), shot.device, validationWanted());
  std::vector<lab::ReloadTiming> timings = lab::benchReload(bench, shot, options.repeats);
  if (options.json) {
    Json json;
    json["device"] = bench.device().info().name;
    json["shot"] = lab::toJson(shot);
    for (const auto& t : timings)
      json["reload"].push_back({{"edited", t.edit},
                                {"watch_ms", t.watch},
                                {"evaluate_ms", t.evaluate},
                                {"compile_ms", t.compile},
                                {"build_ms", t.build},
                                {"first_frame_ms", t.first_frame},
                                {"later_frame_ms", t.later_frame},
                                {"added_ms", t.added()}});
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::printf("%s at %dx%d on %s, milliseconds, medians of %d\n\n%s", shot.pipeline.c_str(), shot.width, shot.height,
              bench.device().info().name.c_str(), options.repeats, lab::tableOf(timings).c_str());
}

}  // namespace

void registerBench(CLI::App& program, const Home& home) {
  CLI::App* command = program.add_subcommand("bench", "Measure reload, frame and pass times");
  command->require_subcommand(1);
  auto options = std::make_shared<ReloadOptions>();
  CLI::App* of_reload =
      command->add_subcommand("reload", "Measure the time from a save to the first picture with the edit");
  of_reload->add_option("--repeats", options->repeats, "edits of each kind")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  of_reload->add_flag("--json", options->json, "report as JSON");
  options->shot.addWithPipeline(*of_reload);
  of_reload->callback([options, &home] { reload(home, *options); });
  registerBenchFrames(*command, home);
  registerBenchSlopes(*command, home);
}

}  // namespace strobe::app
