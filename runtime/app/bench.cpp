// SPDX-License-Identifier: MIT
#include "app/bench.h"

#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/files.h"
#include "app/shot_options.h"
#include "base/log.h"
#include "image/comparison.h"
#include "lab/reload_bench.h"
#include "lab/value_bench.h"
#include "stability/curves_page.h"
#include "stability/curves_run.h"

namespace strobe::app {

namespace {

struct Options {
  ShotOptions shot;
  int repeats = 15;
  bool json = false;
  std::vector<std::string> tries;
  std::string against;
};

void reload(const Home& own, const Options& options) {
  lab::Shot shot = options.shot.resolve();
  if (shot.width == 0) shot.width = 160, shot.height = 90;
  lab::HomeCopy copy(own);
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

void values(const Home& home, const Options& options) {
  lab::Shot shot = options.shot.resolve();
  lab::Workbench bench(home, shot.device, validationWanted());
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

// ---- extremes

struct ExtremesOptions {
  bool wanted = false, json = false;
  std::string file = "experiments/extremes.lua", out = "out/extremes", size, only, markdown, from, device;
  int truth_samples = 0;
};

// The command that repeats it.
std::string commandOf(const ExtremesOptions& options) {
  std::string line = "strobe bench --extremes";
  auto add = [&line](const char* option, const std::string& value) {
    if (!value.empty()) line += fmt::format(" {} {}", option, value);
  };
  if (options.file != ExtremesOptions().file) add("--file", options.file);
  add("--size", options.size);
  add("--samples-of-truth", options.truth_samples ? std::to_string(options.truth_samples) : "");
  add("--only", options.only);
  add("--out", options.out);
  add("--markdown", options.markdown);
  return line;
}

stability::curves::Experiment experimentOf(const Home& home, const ExtremesOptions& options) {
  std::array<int, 2> size = options.size.empty() ? std::array<int, 2>{} : lab::parseSize(options.size);
  stability::curves::Experiment experiment = stability::curves::readExperiment(home, hereOrAtHome(home, options.file));
  if (!options.only.empty()) experiment.keepOnly(options.only);
  if (size[0]) experiment.width = size[0], experiment.height = size[1];
  if (options.truth_samples) experiment.setTruthSamples(options.truth_samples);
  return experiment;
}

stability::curves::Report measured(const Home& home, const ExtremesOptions& options) {
  stability::curves::Experiment experiment = experimentOf(home, options);
  lab::Workbench bench(home, options.device, validationWanted());
  stability::curves::Report report = stability::curves::measure(experiment, bench);
  refuseMessages(bench.device());
  report.command = commandOf(options);
  // Laid out from the numbers as they are written, so that `--from` gives the same page.
  stability::curves::Report written = stability::curves::reportFrom(stability::curves::toJson(report), "the report");
  stability::curves::retell(written, experiment);
  return written;
}

// A report that was written before, with the texts of the experiment as it stands.
stability::curves::Report reread(const Home& home, const ExtremesOptions& options) {
  Json json = Json::parse(readText(options.from), nullptr, false);
  stability::curves::Report report = stability::curves::reportFrom(json, options.from);
  stability::curves::retell(report, experimentOf(home, options));
  return report;
}

void extremes(const Home& home, const ExtremesOptions& options) {
  double started_s = clockSeconds();
  Path page = options.out.ends_with(".html") ? Path(options.out) : Path(options.out) / "extremes.html";
  Path numbers = Path(page).replace_extension(".json");
  requireWritable(std::filesystem::absolute(page).parent_path());
  Path markdown = options.markdown;
  if (!markdown.empty()) requireWritable(std::filesystem::absolute(markdown).parent_path(), "--markdown");
  stability::curves::Report report = options.from.empty() ? measured(home, options) : reread(home, options);

  std::vector<Path> files = {page, numbers};
  Json json = stability::curves::toJson(report);
  writeFileAtomically(page, stability::curves::pageOf(report));
  writeFileAtomically(numbers, json.dump(1) + "\n");
  if (!markdown.empty()) {
    files.push_back(markdown);
    Path beside = std::filesystem::absolute(page).lexically_relative(std::filesystem::absolute(markdown).parent_path());
    writeFileAtomically(markdown, stability::curves::markdownOf(report, beside.generic_string()));
  }
  std::fputs((options.json ? json.dump(1) + "\n" : stability::curves::textOf(report)).c_str(), stdout);
  for (const Path& file : files)
    if (!options.json) std::printf("%s\n", file.c_str());
  note(fmt::format("done in {:.0f} s", clockSeconds() - started_s));
}

CLI::Option* addExtremes(CLI::App& command, ExtremesOptions& options) {
  CLI::Option* wanted = command.add_flag(
      "--extremes", options.wanted, "error of each method against speed, scale, offset and other extremes, as curves");
  auto add = [&](CLI::Option* option) { option->needs(wanted); };
  add(command.add_option("--file", options.file, "an experiment (scripts/strobe/extremes.lua)")->capture_default_str());
  add(command
          .add_option("-o,--out", options.out,
                      "folder for extremes.html and extremes.json, or a name that ends in .html")
          ->capture_default_str());
  add(command.add_option("--markdown", options.markdown, "write the reading as Markdown as well")->type_name("FILE"));
  add(command.add_option("--only", options.only, "one axis by its name, or variants")->type_name("NAME"));
  add(command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels (default: the experiment's)"));
  add(command
          .add_option("--samples-of-truth", options.truth_samples, "time samples of truth (default: the experiment's)")
          ->check(CLI::Range(1, 65536)));
  add(command
          .add_option("--from", options.from,
                      "lay out this report again instead of measuring, with the experiment's texts")
          ->type_name("JSON"));
  add(command.add_option("--device", options.device, "index or part of the name of a Vulkan device"));
  add(command.add_flag("--json", options.json, "print the report as JSON"));
  return wanted;
}

}  // namespace

void registerBench(CLI::App& program, const Home& home) {
  CLI::App* command =
      program.add_subcommand("bench", "Measure what the program costs, and where its methods stop being trustworthy");
  command->require_subcommand(0, 1);
  auto of_extremes = std::make_shared<ExtremesOptions>();
  CLI::Option* wanted = addExtremes(*command, *of_extremes);
  command->callback([command, of_extremes, &home] {
    if (of_extremes->wanted) return extremes(home, *of_extremes);
    if (!command->get_subcommands().empty()) return;
    std::vector<std::string> names;
    for (const CLI::App* one : command->get_subcommands({})) names.push_back(one->get_name());
    throw Error(fmt::format("bench wants --extremes or a command: {}; see strobe bench --help", fmt::join(names, ", ")),
                {}, 2);
  });
  auto options = std::make_shared<Options>();
  CLI::App* of_reload = command->add_subcommand("reload", "From saving a file to the first picture made of it");
  of_reload->add_option("--repeats", options->repeats, "edits of each kind")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  of_reload->add_flag("--json", options->json, "report as JSON");
  options->shot.addWithPipeline(*of_reload);
  of_reload->callback([options, &home] { reload(home, *options); });

  auto tried = std::make_shared<Options>();
  const char* what = "What values of parameters change in the picture, and their cost";
  CLI::App* of_values = command->add_subcommand("values", what);
  of_values->add_option("--try", tried->tries, "NAME=VALUE[,NAME=VALUE...] to draw instead of the shot as it is")
      ->required()
      ->allow_extra_args(false);
  of_values->add_option("--against", tried->against, "a picture (of truth, say): report each one's distance from it")
      ->type_name("FILE");
  of_values->add_option("--repeats", tried->repeats, "frames of each")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  of_values->add_flag("--json", tried->json, "report as JSON");
  tried->shot.addWithPipeline(*of_values);
  of_values->callback([tried, &home] { values(home, *tried); });
  for (CLI::App* one : command->get_subcommands({})) one->excludes(wanted);
}

}  // namespace strobe::app
