// SPDX-License-Identifier: MIT
#include "study/tune.h"

#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/files.h"
#include "app/numbers.h"
#include "app/result_files.h"
#include "app/shot_options.h"
#include "base/frozen_home.h"
#include "base/interruption.h"
#include "base/lease.h"
#include "base/lists.h"
#include "base/log.h"
#include "base/numbers.h"
#include "base/process_name.h"
#include "lab/shot_options.h"
#include "page/table.h"
#include "study/gallery.h"
#include "study/report.h"

namespace strobe::app {

namespace {

struct TuneOptions {
  ShotOptions shot;
  double budget_ms = 0, budget_ratio = 0;
  std::string max_error;  // "0.01", or "1.1x"
  std::string base, cost = "frame", measure = "rmse", region = "inner", out;
  std::vector<std::string> vary;
  int evaluations = 120;
  bool json = false;
};

// ---- command line

void requireKnown(const std::string& option, const std::string& name, const std::vector<std::string>& known) {
  if (contains(known, name)) return;
  throw Error(fmt::format("{}: unknown value '{}'{}; there are {}", option, name, didYouMean(name, known),
                          fmt::join(known, ", ")),
              {}, 2);
}

// Measures with a value per region that are lower for a better picture.
std::vector<std::string> errorNames() {
  std::vector<std::string> names;
  for (const study::Measure& measure : study::measures()) {
    bool is_error = measure.per_region && measure.better == study::Better::lower;
    if (is_error && measure.needs == study::Needs::colours && measure.name != "rmse_full")
      names.push_back(measure.name);
  }
  return names;
}

void setLimit(study::TuneRequest& request, const TuneOptions& options) {
  using Limit = study::TuneRequest::Limit;
  int given = (options.budget_ms > 0) + (options.budget_ratio > 0) + !options.max_error.empty();
  if (given != 1)
    throw Error(fmt::format("{} of --budget-ms, --budget-ratio and --max-error {}: tune needs exactly one",
                            given == 0   ? "none"
                            : given == 2 ? "two"
                                         : "three",
                            given == 0 ? "is given" : "are given"),
                {}, 2);
  if (options.budget_ms > 0) request.limits = Limit::ms, request.limit = options.budget_ms;
  if (options.budget_ratio > 0) request.limits = Limit::ratio, request.limit = options.budget_ratio;
  if (options.max_error.empty()) return;
  bool is_ratio = options.max_error.ends_with("x");
  request.limits = is_ratio ? Limit::error_ratio : Limit::error;
  request.limit = finiteNumber(options.max_error.substr(0, options.max_error.size() - is_ratio)).value_or(0);
  if (!(request.limit > 0))
    throw Error(
        fmt::format("--max-error '{}' is neither a number above 0 nor a multiple of the base's error such as 1.1x",
                    options.max_error),
        {}, 2);
}

study::TuneRequest requestOf(const TuneOptions& options) {
  study::TuneRequest request;
  setLimit(request, options);
  request.shot = options.shot.resolve();
  request.vary = options.vary, request.base = options.base;
  request.measure = options.measure, request.region = options.region;
  requireKnown("--measure", request.measure, errorNames());
  requireKnown("--region", request.region, study::regionNames());
  request.own = options.cost == "own";
  request.evaluations = options.evaluations;
  return request;
}

// Command line that repeats the run.
std::string commandOf(const TuneOptions& options, const study::TuneRequest& request) {
  std::string line = lab::commandOf(request.shot);
  line.replace(0, line.find(" render ") + 8, "strobe tune ");
  if (size_t out = line.rfind(" -o "); out != std::string::npos) line.erase(out);
  auto add = [&line](const std::string& option, const std::string& value, const std::string& usual = "") {
    if (!value.empty() && value != usual) line += " " + option + " " + value;
  };
  if (options.budget_ms > 0) add("--budget-ms", fmt::format("{}", options.budget_ms));
  if (options.budget_ratio > 0) add("--budget-ratio", fmt::format("{}", options.budget_ratio));
  add("--max-error", options.max_error);
  add("--base", options.base);
  add("--cost", options.cost, "frame");
  add("--measure", options.measure, "rmse");
  add("--region", options.region, "inner");
  add("--vary", fmt::format("{}", fmt::join(options.vary, ",")));
  add("--evaluations", std::to_string(options.evaluations), std::to_string(TuneOptions().evaluations));
  add("-o", options.out);
  return line;
}

// ---- output

std::string goalText(const study::TuneRequest& request, const std::string& base) {
  using Limit = study::TuneRequest::Limit;
  std::string cost = request.own ? "own cost" : "cost", error = fmt::format("{} ({})", request.measure, request.region);
  switch (request.limits) {
    case Limit::ms:
      return fmt::format("the least {} within {} ms of {}", error, request.limit, cost);
    case Limit::ratio:
      return fmt::format("the least {} within {} times the {} of {}", error, request.limit, cost, base);
    case Limit::error:
      return fmt::format("the least {} within a {} of {}", cost, error, request.limit);
    case Limit::error_ratio:
      break;
  }
  return fmt::format("the least {} within {} times the {} of {}", cost, request.limit, error, base);
}

std::string textOf(const script::Settings& sets) {
  std::vector<std::string> texts;
  for (const auto& [name, value] : sets) texts.push_back(name + " " + lab::plainText(value));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string tableOf(const study::TuneRequest& request, const study::Tuned& tuned, const study::Results& results) {
  const study::Measure &error = study::measureNamed(request.measure), &ms = study::measureNamed(request.msName()),
                       &ratio = study::measureNamed(request.ratioName());
  page::Table table;
  table.columns = {"",
                   {study::headOf(error) + ", " + request.region, true},
                   {study::headOf(ms), true},
                   {study::headOf(ratio), true},
                   "changed"};
  auto add = [&](const std::string& name, const study::Measured& one) {
    table.add({name, page::TableCell(one.error, study::shownValue(error, one.error)),
               page::TableCell(one.ms, study::shownValue(ms, one.ms)),
               page::TableCell(one.ratio, study::shownValue(ratio, one.ratio)), textOf(one.changed)});
  };
  if (tuned.chosen) add("chosen", *tuned.chosen);
  if (tuned.nearest) add("nearest", *tuned.nearest);
  add(results.arms[0].name + ", as given", tuned.start);
  if (!request.base.empty()) add(results.arms[1].name, tuned.base);
  return page::textOf(table);
}

Json jsonOf(const study::Measured& one) {
  Json json = {{"changed", Json::object()}, {"error", one.error},    {"whole_error", one.whole_error}, {"ms", one.ms},
               {"cost", one.ratio},         {"command", one.command}};
  for (const auto& [name, value] : one.changed) json["changed"][name] = plan::toJson(value);
  return json;
}

Json jsonOf(const study::Tuned& tuned, const Path& file) {
  Json json = {{"met", tuned.chosen.has_value()},
               {"evaluations", tuned.evaluations},
               {"finished", tuned.finished},
               {"start", jsonOf(tuned.start)},
               {"base", jsonOf(tuned.base)}};
  if (tuned.chosen) json["chosen"] = jsonOf(*tuned.chosen), json["preset"] = file.string();
  if (tuned.nearest) json["nearest"] = jsonOf(*tuned.nearest);
  json["results"] = study::toJson(tuned.results);
  return json;
}

// Command that renders with the preset: the shot without the settings that the preset holds.
std::string renderCommand(lab::Shot shot, const Path& file) {
  std::erase_if(shot.sets, [](const script::Setting& set) { return set.first.find('.') == std::string::npos; });
  shot.sets.emplace_back(plan::kPresetSetting, file.string());
  return lab::commandOf(shot);
}

// "0.0167 (whole picture 0.0104) at a cost of 0.383".
std::string textOf(const study::TuneRequest& request, const study::Measured& one) {
  std::string whole = request.region == "whole" ? "" : fmt::format(" (whole picture {:.4g})", one.whole_error);
  return fmt::format("{} {:.4g}{} at a cost of {:.3f}", request.measure, one.error, whole, one.ratio);
}

std::string choiceText(const study::TuneRequest& request, const study::Tuned& tuned) {
  const std::optional<study::Measured>& shown = tuned.chosen ? tuned.chosen : tuned.nearest;
  if (!shown) return "Nothing could be measured.";
  std::string settings = shown->changed.empty() ? "nothing changed" : textOf(shown->changed);
  std::string text =
      fmt::format("{}: {}, {}; as given {}", tuned.chosen ? "Chosen" : "No setting met the limit; the nearest",
                  settings, textOf(request, *shown), textOf(request, tuned.start));
  return text + (request.base.empty() ? "." : fmt::format("; {} {}.", request.base, textOf(request, tuned.base)));
}

void explain(const study::TuneRequest& request, study::Tuned& tuned) {
  const std::string& base = tuned.results.arms[1].name;
  tuned.results.question = "Which settings give " + goalText(request, base) + "?";
  tuned.results.note = fmt::format(
      "{} {} evaluations over {} parameters; a point names its changed parameters. The search began with points that "
      "fill the space, kept the best points of each level, and then made {}. Cost is the time of {}, divided by the "
      "time of {} in the same rounds.",
      choiceText(request, tuned), tuned.evaluations, tuned.results.axes.size(),
      tuned.finished ? "steps along each parameter until no step was better"
                     : "steps along each parameter until the evaluations were used up",
      request.own ? "the passes that a frame without blur does not have" : "a frame", base);
}

void tune(const Home& home, TuneOptions options) {
  double started_s = clockSeconds();
  study::TuneRequest request = requestOf(options);
  if (options.out.empty()) options.out = (Path("out/tune") / Path(request.shot.pipeline).stem()).string() + ".lua";
  Path file = options.out, folder = file.parent_path() / file.stem();
  if (file.extension() != ".lua") throw Error(fmt::format("--out '{}': a preset is a .lua file", options.out), {}, 2);
  // Report mistakes before anything is written.
  study::spaceOf(script::evaluatePipeline(home, {request.shot.pipeline, request.shot.sets}), {}, request);
  if (!request.base.empty()) script::evaluatePipeline(home, {request.base, {}});
  requireWritable(folder);
  Interruption interruption;
  const std::unique_ptr<Lease> claim = Lease::ofFolder(folder);
  study::Store store(folder);
  FrozenHome frozen(home, store.folder() / (".inputs." + processName()));
  lab::Workbench bench(frozen.home(), request.shot.device, validationWanted());
  study::Tuned tuned = study::tune(request, bench, store);
  bench.device().refuseMessages();
  explain(request, tuned);
  tuned.results.command = commandOf(options, request);
  // Read back from their JSON, so that `report` gives the same page.
  study::Results results = study::resultsFrom(study::toJson(tuned.results), "the results");
  std::vector<Path> files = writeResults(results, folder);
  std::string goal = goalText(request, results.arms[1].name);
  if (tuned.chosen) {
    std::string what = fmt::format("{}, {}x{}: {} {:.4g}. ", results.title, results.width, results.height,
                                   request.measure, tuned.chosen->error);
    writeFileAtomically(file, study::presetText({what, "Goal: " + goal}, tuned.values));
    files.insert(files.begin(), file);
  }
  note(fmt::format("{} in {:.0f} s", countText(size_t(tuned.evaluations), "evaluation"), clockSeconds() - started_s));
  if (options.json) {
    std::printf("%s\n", jsonOf(tuned, file).dump(1).c_str());
  } else {
    std::printf("%s\n%s:\n%s\n", study::Report(results, folder).text().c_str(), goal.c_str(),
                tableOf(request, tuned, results).c_str());
    for (const Path& one : files) std::printf("%s\n", one.c_str());
    if (tuned.chosen) std::printf("\n%s\n", renderCommand(request.shot, file).c_str());
  }
  if (!tuned.chosen)
    throw Error(
        fmt::format("no tried setting meets the limit of '{}': see {}", goal, (folder / "report.html").string()));
}

}  // namespace

void registerTune(CLI::App& program, const Home& home) {
  auto options = std::make_shared<TuneOptions>();
  CLI::App* command = program.add_subcommand(
      "tune", "Find the best setting of a pipeline within a budget, or the cheapest within an error, as a preset");
  command->add_option("--budget-ms", options->budget_ms, "maximum time, milliseconds: find the least error within it")
      ->type_name("B")
      ->check(aboveZero());
  command->add_option("--budget-ratio", options->budget_ratio, "maximum cost, as a multiple of the base's cost")
      ->type_name("R")
      ->check(aboveZero());
  command
      ->add_option("--max-error", options->max_error,
                   "maximum error: find the least cost within it; 1.1x: a multiple of the base's error")
      ->type_name("E|Rx");
  command
      ->add_option("--base", options->base, "base of relative costs and errors (default: the tuned pipeline as given)")
      ->type_name("PIPELINE");
  command
      ->add_option("--cost", options->cost,
                   "time of the frame, or only of the passes that a frame without blur does not have")
      ->type_name("frame|own")
      ->check(CLI::IsMember({"frame", "own"}))
      ->capture_default_str();
  command->add_option("--measure", options->measure, "measure of the error")->capture_default_str();
  command->add_option("--region", options->region, "region of the error")->capture_default_str();
  command->add_option("--vary", options->vary, "parameters to vary (default: all parameters that are not set)")
      ->delimiter(',')
      ->type_name("NAME[,NAME]")
      ->allow_extra_args(false);
  command->add_option("--evaluations", options->evaluations, "maximum number of drawn and measured pictures")
      ->check(CLI::Range(10, 100000))
      ->capture_default_str();
  command->add_option("-o,--out", options->out,
                      "preset to write, a .lua file; results go into the folder of the same name beside it (default: "
                      "out/tune/PIPELINE.lua)");
  command->add_flag("--json", options->json, "print the choice and the results as JSON");
  options->shot.addWithPipeline(*command);
  command->callback([options, &home] { tune(home, *options); });
}

}  // namespace strobe::app
