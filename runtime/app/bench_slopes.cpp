// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/files.h"
#include "app/numbers.h"
#include "app/shot_options.h"
#include "base/log.h"
#include "bench/slopes_report.h"
#include "gpu/choice.h"
#include "study/measures.h"
#include "study/points.h"

namespace strobe::app {

namespace {

struct SlopesOptions {
  std::string file = "experiments/costs/costs.lua";
  std::string size, only, out, device;
  int rounds = 0;
  bench::Gpu gpu{616, 10};
  bool json = false;
};

constexpr std::array<std::array<int, 2>, 2> kDemandSizes = {{{1920, 1080}, {3840, 2160}}};

// ---- measurement

// Points of an axis in one shot of the experiment.
struct Points {
  size_t axis = 0, shot = 0;
  std::vector<const study::Group*> groups;
};

std::vector<Points> pointsOf(const study::Experiment& experiment) {
  std::vector<Points> all;
  for (const study::Group& group : experiment.groups) {
    if (!experiment.shots[group.shot].missing.empty()) continue;
    if (group.at.size() != 1)
      throw Error("slopes need one varied axis at a time: vary = { experiment.each { ... } }", {experiment.file}, 2);
    size_t axis = group.at.front().axis;
    auto found = std::find_if(all.begin(), all.end(),
                              [&](const Points& points) { return points.axis == axis && points.shot == group.shot; });
    if (found == all.end()) found = all.insert(all.end(), Points{axis, group.shot, {}});
    found->groups.push_back(&group);
  }
  if (all.empty()) throw Error("no shot of the experiment can be drawn here", {experiment.file});
  return all;
}

bench::NamedShot named(const study::Experiment& experiment, const study::Group& group, const study::StudiedArm& arm) {
  std::string scene = experiment.shots[group.shot].name;
  if (!group.at.empty()) scene += ", " + study::describe(experiment, group);
  return {scene, arm.name, study::shotOf(experiment, group, arm)};
}

std::vector<bench::NamedShot> shotsOf(const study::Experiment& experiment, const study::Group& group) {
  std::vector<bench::NamedShot> shots;
  for (size_t arm : group.arms) shots.push_back(named(experiment, group, experiment.arms[arm]));
  return shots;
}

// Value of a measure in the picture of each shot. A picture without a value gets the first value of the list. Throws
// `Error` if no picture has a value.
std::vector<double> counted(lab::Batch& batch, const std::vector<bench::NamedShot>& shots, const std::string& measure) {
  std::vector<double> counts;
  for (const bench::NamedShot& one : shots) {
    std::shared_ptr<const lab::Picture> picture = batch.picture(one.shot);
    study::MeasureInput input;
    input.picture = picture.get();
    study::Values values = study::measured(input, {measure}, {});
    counts.push_back(values.count(measure) ? values[measure].begin()->second : std::nan(""));
  }
  auto known = std::find_if(counts.begin(), counts.end(), [](double count) { return !std::isnan(count); });
  if (known == counts.end())
    throw Error(fmt::format("no picture of '{}' has a value of the measure {}", shots.front().scene, measure));
  const double first = *known;
  for (double& count : counts) count = std::isnan(count) ? first : count;
  return counts;
}

// Position of each shot of a group on the axis: the axis value, or a measure of the shot's picture.
std::vector<double> placesOf(lab::Batch& batch, const study::Experiment& experiment, const study::Group& group,
                             const std::vector<bench::NamedShot>& shots) {
  const study::Axis& axis = experiment.axes[group.at.front().axis];
  if (!axis.against.empty()) return counted(batch, shots, axis.against);
  return std::vector<double>(shots.size(), axis.values[group.at.front().value].get<double>());
}

bench::AxisRun outlineOf(const study::Experiment& experiment, const Points& points) {
  const study::Axis& axis = experiment.axes[points.axis];
  bench::AxisRun result{axis.name, axis.title, axis.unit, {}, {}, {}};
  for (const study::Cost& cost : axis.costs)
    result.expected.push_back({cost.part, cost.arm, bench::growthNamed(cost.grows), cost.why});
  return result;
}

bench::AxisRun measured(lab::Workbench& bench, const study::Experiment& experiment, const Points& points) {
  bench::AxisRun axis = outlineOf(experiment, points);
  std::vector<bench::NamedShot> shots;
  lab::Batch batch(bench);
  for (const study::Group* group : points.groups) {
    std::vector<bench::NamedShot> of_group = shotsOf(experiment, *group);
    std::vector<double> places = placesOf(batch, experiment, *group, of_group);
    axis.x.insert(axis.x.end(), places.begin(), places.end());
    shots.insert(shots.end(), of_group.begin(), of_group.end());
  }
  axis.run = bench::measure(bench, shots, experiment.rounds);
  return axis;
}

// Demand of every method in every shot, without the experiment's axes, at each of kDemandSizes.
std::vector<bench::Demand> demandsOf(lab::Workbench& bench, const study::Experiment& experiment) {
  std::vector<bench::Demand> demands;
  lab::Batch batch(bench);
  for (size_t s = 0; s < experiment.shots.size(); ++s) {
    if (!experiment.shots[s].missing.empty()) continue;
    for (const study::StudiedArm& arm : experiment.arms) {
      bench::NamedShot shot = named(experiment, {s, {}, {}}, arm);
      bench::Run once = bench::measure(bench, std::vector{shot}, lab::Rounds());
      for (const auto& [width, height] : kDemandSizes) {
        bench::Demand& demand = demands.emplace_back(bench::demandAt(batch, shot, once.shots[0], width, height));
        if (arm.published && arm.published->shot == shot.scene)
          demand.published_fps = arm.published->fps, demand.published_by = arm.published->by;
      }
    }
  }
  return demands;
}

// ---- the command

study::Experiment experimentOf(const Home& home, const SlopesOptions& options) {
  study::Experiment experiment = study::readExperiment(home, hereOrAtHome(home, options.file));
  if (!options.only.empty()) study::keepOnly(experiment, options.only);
  if (!options.size.empty()) {
    std::array<int, 2> size = lab::parseSize(options.size);
    experiment.width = size[0], experiment.height = size[1];
  }
  if (options.rounds > 0) experiment.rounds = {options.rounds, options.rounds, 0};
  return experiment;
}

std::string commandOf(const Home& home, const SlopesOptions& options) {
  std::string line = "strobe bench slopes " + lab::shellWord(home.shown(options.file));
  if (!options.size.empty()) line += " --size=" + options.size;
  if (!options.only.empty()) line += " --only=" + lab::shellWord(options.only);
  if (options.rounds > 0) line += fmt::format(" --rounds={}", options.rounds);
  return line +
         fmt::format(" --bandwidth={:g} --ray-rate={:g}", options.gpu.gigabytes_per_s, options.gpu.gigarays_per_s);
}

bench::Slopes slopesOf(const Home& home, const SlopesOptions& options) {
  study::Experiment experiment = experimentOf(home, options);
  std::vector<Points> points = pointsOf(experiment);
  bench::Slopes slopes{commandOf(home, options), experiment.title, experiment.question, {}, {}, {}, options.gpu};
  lab::Workbench bench(home, options.device, validationWanted());
  for (const Points& of_axis : points) {
    slopes.axes.push_back(measured(bench, experiment, of_axis));
    slopes.axes.back().run.command = slopes.command;
    slopes.fits.push_back(bench::fitsOf(slopes.axes.back()));
    if (!experiment.partial) bench::requireKnownParts(slopes.axes.back(), slopes.fits.back());
    note(fmt::format("{} of {} axes", slopes.axes.size(), points.size()));
  }
  slopes.demands = demandsOf(bench, experiment);
  bench.device().refuseMessages();
  return slopes;
}

void slopes(const Home& home, const SlopesOptions& options) {
  if (!options.out.empty()) requireWritable(options.out);
  const bench::Slopes found = slopesOf(home, options);
  std::string json = bench::toJson(found).dump(1) + "\n";
  const Path folder = options.out;
  if (!options.out.empty()) {
    writeFileAtomically(folder / "slopes.json", json);
    writeFileAtomically(folder / "index.html", page::htmlOf(bench::pageOf(found)));
  }
  std::fputs((options.json ? json : bench::textOf(found)).c_str(), stdout);
  if (options.out.empty() || options.json) return;
  for (const char* file : {"index.html", "slopes.json"}) std::printf("%s\n", (folder / file).c_str());
}

}  // namespace

void registerBenchSlopes(CLI::App& bench, const Home& home) {
  auto options = std::make_shared<SlopesOptions>();
  CLI::App* command =
      bench.add_subcommand("slopes", "Measure how the frame time grows with the size and content of the frame");
  command->add_option("file", options->file, "an experiment with axes that vary one at a time")->capture_default_str();
  command->add_option("--rounds", options->rounds, "timed frames of each method (default: rounds of the experiment)")
      ->check(CLI::Range(1, 10000));
  command->add_option("--size", options->size, "WIDTHxHEIGHT instead of the experiment's");
  command->add_option("--only", options->only, "only points with arm=NAME, shot=NAME, AXIS, AXIS=VALUE, ...");
  command
      ->add_option("--bandwidth", options->gpu.gigabytes_per_s, "memory bandwidth of the GPU of the time bounds, GB/s")
      ->check(aboveZero())
      ->capture_default_str();
  command
      ->add_option("--ray-rate", options->gpu.gigarays_per_s,
                   "ray rate of the GPU of the time bounds, billions of rays per second")
      ->check(aboveZero())
      ->capture_default_str();
  command->add_option("-o,--out", options->out, "folder for index.html and slopes.json");
  command->add_option("--device", options->device, gpu::kDeviceHelp);
  command->add_flag("--json", options->json, "print everything as JSON");
  command->callback([options, &home] { slopes(home, *options); });
}

}  // namespace strobe::app
