// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <memory>
#include <set>

#include "app/batch.h"
#include "app/commands.h"
#include "app/files.h"
#include "app/numbers.h"
#include "app/result_files.h"
#include "app/shot_options.h"
#include "archive/capture_run.h"
#include "base/frozen_home.h"
#include "base/interruption.h"
#include "base/lease.h"
#include "base/log.h"
#include "base/numbers.h"
#include "base/process_name.h"
#include "gpu/choice.h"
#include "lab/shot_options.h"
#include "study/points.h"
#include "study/report.h"
#include "study/run.h"
#include "study/watch.h"
#include "study/worker.h"

namespace strobe::app {

namespace {

constexpr size_t kPackFrom = 10000;  // points of a sweep that packs them by default

struct SweepOptions {
  std::string file, out, only, size, device, share;
  bool dry_run = false, json = false, exr = false, retry = false, pack = false;
  int jobs = 1;
  double time_left_s = 0;
  double truth_error = 0, time_limit_s = gpu::kTimeLimit_s;
  BatchOptions batch;
};

// Command line that repeats the run.
std::string commandOf(const Home& home, const std::string& name, const SweepOptions& options) {
  std::string line = "strobe " + name;
  auto add = [&line](const char* option, const std::string& value) {
    if (!value.empty()) line += fmt::format(" {}{}{}", option, *option ? " " : "", value);
  };
  add("", options.file.empty() ? "" : home.shown(options.file));
  add("--size", options.size);
  if (options.truth_error > 0) add("--truth-error", fmt::format("{:g}", options.truth_error));
  add("--only", options.only.empty() ? "" : "'" + options.only + "'");
  add("-o", options.out);
  return line;
}

// Prints the results and the names of their files. Throws `Error` (exit code 1) if a point failed or is missing, a file
// is damaged, or the results contradict an expectation.
void show(const study::Results& results, const Path& folder, const std::vector<Path>& files, bool json,
          const std::vector<Path>& damaged = {}) {
  std::fputs((json ? study::textOf(results) : study::Report(results, folder).text() + "\n").c_str(), stdout);
  for (const Path& file : files)
    if (!json) std::printf("%s\n", file.c_str());
  std::vector<std::string> wrong, contradicted = results.contradicted();
  for (const Path& file : damaged)
    wrong.push_back(file.string() + ": is damaged and left out; run the same sweep again to make it");
  if (std::string missing = results.missingText(); !missing.empty())
    wrong.push_back("not drawn yet: " + missing + "; run the same sweep again to draw them");
  for (const std::string& failure : results.failed()) wrong.push_back(failure);
  wrong.insert(wrong.end(), contradicted.begin(), contradicted.end());
  throwIfAny(wrong);
}

study::Experiment experimentOf(const Home& home, const std::string& file, const SweepOptions& options,
                               bool evaluate = true) {
  std::array<int, 2> size = options.size.empty() ? std::array<int, 2>{} : lab::parseSize(options.size);
  study::Experiment experiment = study::readExperiment(home, file, evaluate);
  if (!options.only.empty()) study::keepOnly(experiment, options.only);
  if (size[0]) experiment.width = size[0], experiment.height = size[1];
  experiment.truth_error = options.truth_error;
  return experiment;
}

// Share of a task of a Slurm array: the tasks MIN, MIN + STEP, ... are the shares 1, 2, ... of COUNT. Whole outside of
// an array.
study::Share shareOfArray() {
  const char* task = std::getenv("SLURM_ARRAY_TASK_ID");
  if (!task) return {};
  auto number = [](const char* name, size_t otherwise) {
    const char* text = std::getenv(name);
    return text ? numbersIn<size_t, 1>(text, ',').value_or(std::array<size_t, 1>{0})[0] : otherwise;
  };
  const size_t id = number("SLURM_ARRAY_TASK_ID", 0), first = number("SLURM_ARRAY_TASK_MIN", 0),
               step = number("SLURM_ARRAY_TASK_STEP", 1), of = number("SLURM_ARRAY_TASK_COUNT", 0);
  const bool is_regular = step > 0 && id >= first && (id - first) % step == 0 && (id - first) / step < of;
  if (!is_regular)
    throw Error(
        fmt::format("task {} of this Slurm array has no share, because its tasks are not at equal distances; give "
                    "--share I/N",
                    task),
        {}, 2);
  const study::Share share = {(id - first) / step + 1, of};
  note(fmt::format("task {} of a Slurm array: --share {}/{}", task, share.index, share.of));
  return share;
}

study::Share shareOf(const std::string& text) {
  if (text.empty()) return shareOfArray();
  const auto numbers = numbersIn<size_t, 2>(text, '/');
  if (!numbers || (*numbers)[0] < 1 || (*numbers)[0] > (*numbers)[1])
    throw Error(fmt::format("--share '{}' is not I/N with whole numbers and I from 1 to N, such as 2/8", text), {}, 2);
  return {(*numbers)[0], (*numbers)[1]};
}

// Points of a share, and its expected time if points were drawn in the folder before.
std::string describe(const study::Experiment& experiment, const std::vector<size_t>& shares, const study::Share& share,
                     double seconds_per_point) {
  size_t points = 0;
  std::set<std::string> truths;
  for (size_t i = 0; i < shares.size(); ++i) {
    if (shares[i] != share.index) continue;
    const study::Group& group = experiment.groups[i];
    points += group.arms.size();
    truths.insert(study::commandOf(experiment.shots[group.shot], truthShotOf(experiment, group)));
  }
  std::string text = fmt::format("{}, {}", countText(points, "point"), countText(study::countTruths(truths), "truth"));
  if (seconds_per_point > 0) text += fmt::format(", about {:.0f} s", double(points) * seconds_per_point);
  return share.isWhole() ? text : fmt::format("share {}: {}", share.text(), text);
}

// Hint for shares without points.
constexpr const char* kEmptyShare =
    "a share has no points, because all points with the same truth are in one share; give fewer shares, or start "
    "several programs without --share, which divide the points among themselves";

void list(study::Experiment experiment, const study::Share& share, const SweepOptions& options) {
  const std::vector<size_t> shares = study::sharesOf(experiment, share.of);
  const double seconds = study::secondsPerPoint(options.out);
  std::string counts;
  for (size_t i = 1; i <= share.of; ++i) counts += describe(experiment, shares, {i, share.of}, seconds) + "\n";
  if (std::set(shares.begin(), shares.end()).size() < share.of) note(kEmptyShare);
  std::vector<study::Group> mine;
  for (size_t i = 0; i < shares.size(); ++i)
    if (shares[i] == share.index) mine.push_back(experiment.groups[i]);
  experiment.groups = std::move(mine);
  Json points = Json::array();
  for (const study::Group& group : experiment.groups)
    for (size_t arm : group.arms) {
      Json at = Json::object();
      for (const study::At& one : group.at)
        at[experiment.axes[one.axis].name] = experiment.axes[one.axis].values[one.value];
      points.push_back({{"shot", experiment.shots[group.shot].name}, {"at", at}, {"arm", experiment.arms[arm].name}});
    }
  std::fputs((options.json ? points.dump(1) + "\n" : study::listOf(experiment) + counts).c_str(), stdout);
}

// Writes the result files, then removes the outline, so that `report` always finds either of these. Reads the results
// back from their JSON first, so that `report` gives the same page.
std::vector<Path> conclude(study::Results& results, const study::Store& store, const ResultNames& names) {
  results.command = store.command;
  results = study::resultsFrom(study::toJson(results), "the results");
  std::vector<Path> files = writeResults(results, store.folder(), names);
  std::filesystem::remove(store.outline);
  return files;
}

// Adds the number of kept points to the message of a pass that exceeds the time limit.
void limitTime(lab::Workbench& bench, double seconds, const Path& outline) {
  bench.device().setTimeLimit(seconds, [outline](const std::string& text) {
    std::fprintf(stderr, "strobe: %s (--time-limit); %s\n", text.c_str(), study::keptIn(outline).c_str());
    std::fflush(stderr);
    std::_Exit(1);
  });
}

// Adds the number of kept points to the message of a lost device or of a stop.
template <class Run>
study::Results ranTo(const Path& outline, const Run& run) {
  try {
    return run();
  } catch (const gpu::DeviceLost& lost) {
    throw Error(fmt::format("{}; {}", lost.what(), study::keptIn(outline)));
  } catch (const Stopped& stopped) {
    throw Stopped{stopped.reason, study::keptIn(outline)};
  }
}

// Job that repeats the command line in several tasks.
BatchJob jobOf(const SweepOptions& options, const std::string& file) {
  const std::string program = std::filesystem::read_symlink(Home::kOwnProgram);
  Words sweep = {program, "sweep", options.file, "-o", options.out};
  auto add = [&sweep](const std::string& option, const std::string& value) {
    if (!value.empty()) sweep.insert(sweep.end(), {option, value});
  };
  add("--only", options.only), add("--size", options.size), add("--device", options.device);
  if (options.truth_error > 0) add("--truth-error", fmt::format("{:g}", options.truth_error));
  if (options.time_limit_s != gpu::kTimeLimit_s) add("--time-limit", fmt::format("{:g}", options.time_limit_s));
  if (options.jobs > 1) add("--jobs", std::to_string(options.jobs));
  if (options.exr) sweep.push_back("--exr");
  if (options.retry) sweep.push_back("--retry");
  if (options.pack) sweep.push_back("--pack");
  return {.name = Path(file).stem(),
          .sweep = std::move(sweep),
          .report = {program, "report", options.out, "--experiment", options.file},
          .start = std::filesystem::current_path(),
          .logs = {}};
}

// Clocks do not decide results, but the times that `status` prints.
void compareClocks(const Path& folder) {
  const double ahead_s = timeIn(folder) - double(std::time(nullptr));
  if (std::abs(ahead_s) > kLease_s)
    warn(fmt::format(
        "{}: the clock of the file system is {:.0f} s {} the clock of this machine; results do not depend on "
        "clocks",
        folder.string(), std::abs(ahead_s), ahead_s > 0 ? "ahead of" : "behind"));
}

// Ends a share: other programs draw the other shares, so nothing is concluded.
void showShare(const study::Results& results, const study::Share& share, const Path& folder, bool json) {
  if (json) std::fputs(study::textOf(results).c_str(), stdout);
  else
    fmt::print("share {}: {}; `strobe report {}` shows all shares\n", share.text(),
               countText(results.points(), "point"), folder.string());
  if (results.points() == 0) note(kEmptyShare);
  throwIfAny(results.failed());
}

void sweep(const Home& home, const SweepOptions& options) {
  double started_s = clockSeconds();
  std::string file = hereOrAtHome(home, options.file);
  const study::Share share = shareOf(options.share);
  if (!options.dry_run) requireWritable(options.out);
  study::Experiment checked = experimentOf(home, file, options);
  if (options.dry_run) return list(checked, share, options);
  if (options.batch.isWanted())
    return startBatch(options.batch, jobOf(options, file), checked.points(), checked.truths(), options.out);
  Interruption interruption(options.time_left_s);
  study::Store store(options.out);
  store.requires_exr = options.exr, store.retries = options.retry;
  if (options.pack || checked.points() >= kPackFrom)
    store.packPoints(share.isWhole() ? "" : fmt::format("{}of{}", share.index, share.of));
  store.belongTo(checked.title);
  compareClocks(store.workers());
  const ResultNames names;
  store.outline = store.folder() / names.outline, store.command = commandOf(home, "sweep", options);
  FrozenHome frozen(home, store.folder() / (".inputs." + processName()));
  study::Experiment experiment = experimentOf(frozen.home(), file, options, false);
  experiment.share = share;
  auto make = [&] {
    auto bench = std::make_unique<lab::Workbench>(frozen.home(), options.device, validationWanted());
    limitTime(*bench, options.time_limit_s, store.outline);
    return bench;
  };
  study::Helpers helpers(experiment, make, store, options.jobs - 1);
  bool good = true;
  std::unique_ptr<lab::Workbench> bench = make();
  lab::Batch batch(*bench);
  study::Results results =
      ranTo(store.outline, [&] { return study::run(experiment, batch, store, [&] { good = helpers.wait(); }); });
  study::nameInputs(results.inputs, home);
  bench->device().refuseMessages();
  if (!good) throw Error("a process of the sweep failed; see its message above");
  note(fmt::format("{} in {:.0f} s", countText(results.points(), "point"), clockSeconds() - started_s));
  if (!share.isWhole()) return showShare(results, share, options.out, options.json);
  const std::vector<Path> files = conclude(results, store, names);
  show(results, options.out, files, options.json);
}

// Runs the experiment on the pictures of the capture. Each picture is drawn once, when the experiment first needs it.
study::Results measured(const study::Experiment& experiment, archive::Capturing& capturing, const study::Store& store) {
  lab::Batch batch(capturing.bench());
  std::map<std::string, const archive::CapturedFrame*> frames;
  for (const archive::CapturedFrame& frame : capturing.frames())
    frames[batch.contentOf(capturing.shot(frame))] = &frame;
  batch.source = [&](const std::string& content, const lab::Batch::Progress& progress) {
    auto frame = frames.find(content);
    return frame == frames.end() ? nullptr : capturing.draw(*frame->second, progress);
  };
  return study::run(experiment, batch, store);
}

void demo(const Home& home, const SweepOptions& options) {
  double started_s = clockSeconds();
  archive::Order order;
  order.file = hereOrAtHome(home, options.file), order.folder = options.out;
  order.device = options.device, order.validation = validationWanted();
  if (!options.size.empty()) order.size = lab::parseSize(options.size);
  requireWritable(options.out);
  // Report mistakes before anything is written.
  archive::readCapture(home, order.file, order.size);
  study::Experiment checked = experimentOf(home, order.file, options);
  Interruption interruption(options.time_left_s);
  study::Store store(options.out);
  store.belongTo(checked.title);
  store.retries = options.retry;
  store.outline = store.folder() / kDemoNames.outline, store.command = commandOf(home, "demo", options);
  archive::Capturing capturing(home, order, [](const std::string& line) { note(line); });
  limitTime(capturing.bench(), options.time_limit_s, store.outline);
  const study::Experiment experiment = experimentOf(capturing.inputs().home(), order.file, options, false);
  study::Results results = ranTo(store.outline, [&] { return measured(experiment, capturing, store); });
  const std::vector<Path> figures = capturing.finish().figures;
  note(fmt::format("{} in {:.0f} s", countText(experiment.points(), "point"), clockSeconds() - started_s));
  std::vector<Path> files = conclude(results, store, kDemoNames);
  files.insert(files.end(), figures.begin(), figures.end());
  files.push_back(order.folder / archive::kManifestFile);
  show(results, options.out, files, options.json);
}

void addCommon(CLI::App& command, SweepOptions& options) {
  command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels (default: the file's)");
  command.add_option("--device", options.device, gpu::kDeviceHelp);
  command.add_flag("--json", options.json, "print the results as JSON");
  command.add_flag("--retry", options.retry, "draw points again that are set aside after three failed tries");
  command
      .add_option("--time-left", options.time_left_s,
                  "stop after this time, seconds, with exit code 75; start no point that would take longer")
      ->type_name("S")
      ->check(aboveZero());
  addTimeLimit(command, options.time_limit_s);
}

void addSweep(CLI::App& command, SweepOptions& options) {
  addCommon(command, options);
  command.add_option("--jobs", options.jobs, "number of drawing processes; times are measured by one process")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command
      .add_option(
          "--share", options.share,
          "draw only the I-th of N parts of the points, from 1; several programs share one folder (default in an "
          "array of Slurm: the part of the task)")
      ->type_name("I/N");
  command
      .add_option("--truth-error", options.truth_error,
                  "draw truth with more samples until its standard error over the picture is at most this")
      ->type_name("E")
      ->check(aboveZero());
  command.add_flag("--pack", options.pack,
                   fmt::format("move complete points into archives packs/*.zip of {} points; default from {} points on",
                               study::PointFiles::kPerPack, kPackFrom));
  command.add_flag("--exr", options.exr, "keep every picture as points/KEY.exr, linear, with its record");
  addBatch(command, options.batch);
}

struct ReportOptions {
  std::string folder, file;
  bool json = false, still = false;
};

void report(const Home& home, const ReportOptions& options) {
  Path folder = options.folder;
  const ResultNames names = namesIn(folder);
  requireWritable(folder, "the folder");
  study::Results results = study::resultsIn(resultsFile(folder, names));
  std::vector<Path> damaged = study::takePoints(results, folder, true), altered = study::alteredFiles(results, folder);
  damaged.insert(damaged.end(), altered.begin(), altered.end());
  if (!options.file.empty())
    study::relabel(home, results, study::readExperiment(home, hereOrAtHome(home, options.file), false));
  show(results, folder, writeResults(results, folder, names, options.still), options.json, damaged);
}

}  // namespace

void registerSweep(CLI::App& program, const Home& home) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* command = program.add_subcommand("sweep", "Run or continue an experiment, and lay out its results");
  command->add_option("file", options->file, "an experiment (docs/writing-experiments.md)")->required();
  command->add_option("-o,--out", options->out, "folder for result.json, report.html, result.md, table.csv, pictures")
      ->default_str("out/sweep");
  options->out = "out/sweep";
  command->add_option("--only", options->only, "only points with NAME=VALUE[,NAME=VALUE...]: arm, shot or an axis")
      ->type_name("EXPR");
  command->add_flag("--dry-run", options->dry_run, "print the points and draw nothing");
  addSweep(*command, *options);
  command->callback([options, &home] { sweep(home, *options); });
}

void registerReport(CLI::App& program, const Home& home) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = program.add_subcommand("report", "Lay out the results of an experiment again");
  command->add_option("folder", options->folder, "folder of `sweep -o`")->required();
  command->add_option("--experiment", options->file, "use the texts, layout and expectations of this file")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "print the results as JSON");
  command->add_flag("--static", options->still,
                    "make a static page of figures and tables, such as the results in a repository");
  command->callback([options, &home] { report(home, *options); });
}

void registerDemo(CLI::App& program, const Home& home) {
  auto options = std::make_shared<SweepOptions>();
  options->file = "scripts/captures/demo.lua";
  options->out = "out/demo";
  CLI::App* command = program.add_subcommand("demo", "Take a capture, measure it, and show every method beside truth");
  command->add_option("file", options->file, "a capture with `measures` (docs/captures.md)")->capture_default_str();
  command->add_option("-o,--out", options->out, "folder for figure, page, numbers, manifest, pictures and records")
      ->capture_default_str();
  addCommon(*command, *options);
  command->callback([options, &home] { demo(home, *options); });
}

}  // namespace strobe::app
