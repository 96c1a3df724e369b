// SPDX-License-Identifier: MIT
#include "bench/times.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "base/files.h"
#include "lab/shot.h"

namespace strobe::bench {

uint64_t bytesOf(const std::vector<PassTimes>& passes) {
  uint64_t sum = 0;
  for (const PassTimes& pass : passes) sum += pass.bytes();
  return sum;
}

uint64_t raysOf(const std::vector<PassTimes>& passes) {
  uint64_t sum = 0;
  for (const PassTimes& pass : passes) sum += pass.rays;
  return sum;
}

std::string ShotTimes::size() const { return fmt::format("{}x{}", width, height); }
std::string ShotTimes::place() const { return scene + ", " + size(); }
std::string ShotTimes::name() const { return method + ", " + place(); }

std::vector<PassTimes> ShotTimes::parts() const {
  if (passes.empty()) return {};
  std::vector<PassTimes> parts = passes;
  PassTimes rest{kRest, ms, 1};
  for (const PassTimes& pass : passes)
    for (size_t i = 0; i < ms.size(); ++i) rest.ms[i] -= pass.ms[i];
  for (double& left : rest.ms) left = std::max(left, 0.0);
  parts.push_back(std::move(rest));
  return parts;
}

size_t ShotTimes::typicalRound() const {
  double middle = median(ms);
  auto nearer = [&](double a, double b) { return std::abs(a - middle) < std::abs(b - middle); };
  return size_t(std::min_element(ms.begin(), ms.end(), nearer) - ms.begin());
}

const ShotTimes& Run::baseOf(const ShotTimes& shot) const {
  return *std::find_if(shots.begin(), shots.end(), [&](const ShotTimes& one) { return one.place() == shot.place(); });
}

Estimate ratioToBase(const Run& run, const ShotTimes& shot) {
  return estimatedMedian(ratiosOf(shot.ms, run.baseOf(shot).ms));
}

static void append(std::vector<double>& to, const std::vector<double>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

Run joined(const std::vector<Run>& blocks) {
  Run all = blocks.front();
  for (size_t b = 1; b < blocks.size(); ++b)
    for (size_t s = 0; s < all.shots.size(); ++s) {
      const ShotTimes& more = blocks[b].shots[s];
      append(all.shots[s].ms, more.ms);
      append(all.shots[s].interval_ms, more.interval_ms);
      STROBE_ASSERT(more.passes.size() == all.shots[s].passes.size(), "{}", more.name());
      for (size_t p = 0; p < more.passes.size(); ++p) append(all.shots[s].passes[p].ms, more.passes[p].ms);
    }
  return all;
}

// ---- as JSON

static constexpr int kFormat = 1;

static Json toJson(const PassTimes& pass) {
  return {{"name", pass.name},
          {"executions", pass.executions},
          {"bytes_read", pass.bytes_read},
          {"bytes_written", pass.bytes_written},
          {"rays", pass.rays},
          {"ms", pass.ms}};
}

static Json toJson(const ShotTimes& shot) {
  Json json = {{"scene", shot.scene}, {"width", shot.width}, {"height", shot.height},  {"method", shot.method},
               {"shot", shot.shot},   {"ms", shot.ms},       {"passes", Json::array()}};
  if (!shot.interval_ms.empty()) json["interval_ms"] = shot.interval_ms;
  for (const PassTimes& pass : shot.passes) json["passes"].push_back(toJson(pass));
  return json;
}

Json toJson(const Run& run) {
  Json json = {
      {"strobe_bench", kFormat},
      {"command", run.command},
      {"strobe", {{"version", run.version}, {"program", run.program}}},
      {"device", {{"name", run.device}, {"driver", run.driver}, {"backend", run.backend}, {"software", run.software}}},
      {"threads", run.threads},
      {"frames_in_flight", run.frames_in_flight},
      {"environment", run.environment},
      {"shots", Json::array()}};
  for (const ShotTimes& shot : run.shots) json["shots"].push_back(toJson(shot));
  return json;
}

static PassTimes passFrom(const Json& json) {
  return {json.at("name"),          json.at("ms"),  json.at("executions"), json.at("bytes_read"),
          json.at("bytes_written"), json.at("rays")};
}

static ShotTimes shotFrom(const Json& json) {
  ShotTimes shot{json.at("scene"),
                 json.at("method"),
                 json.at("width"),
                 json.at("height"),
                 json.at("shot"),
                 json.at("ms"),
                 json.value("interval_ms", std::vector<double>()),
                 {}};
  for (const Json& pass : json.at("passes")) shot.passes.push_back(passFrom(pass));
  return shot;
}

static Run runFrom(const Json& json) {
  const Json &strobe = json.at("strobe"), &device = json.at("device");
  Run run{json.at("command"),
          strobe.at("version"),
          strobe.at("program"),
          device.at("name"),
          device.at("driver"),
          device.at("backend"),
          device.at("software"),
          json.at("threads"),
          json.at("environment"),
          {},
          json.value("frames_in_flight", size_t{1})};
  for (const Json& shot : json.at("shots")) run.shots.push_back(shotFrom(shot));
  return run;
}

// True if the frame has times, and every pass and the frame interval have a time for each round.
static bool isWhole(const ShotTimes& shot) {
  if (!shot.interval_ms.empty() && shot.interval_ms.size() != shot.ms.size()) return false;
  return !shot.ms.empty() && std::all_of(shot.passes.begin(), shot.passes.end(),
                                         [&](const PassTimes& pass) { return pass.ms.size() == shot.ms.size(); });
}

Run runFrom(const Json& json, const std::string& file) {
  if (!json.is_object() || !json.contains("strobe_bench"))
    throw Error("is not a run of `strobe bench frames` (--save, --json)", {file});
  if (json["strobe_bench"] != kFormat)
    throw Error(
        fmt::format("is a run of format {}; this program reads format {}", json["strobe_bench"].dump(), kFormat),
        {file});
  try {
    Run run = runFrom(json);
    if (!run.shots.empty() && std::all_of(run.shots.begin(), run.shots.end(), isWhole)) return run;
  } catch (const Json::exception&) {
  }
  throw Error("is a damaged run of `strobe bench frames`", {file});
}

Run readRun(const std::string& file) { return runFrom(Json::parse(readText(file), nullptr, false), file); }

// ---- comparable runs

static std::vector<std::string> lackingIn(const Run& run, const Run& others) {
  std::vector<std::string> names;
  for (const ShotTimes& other : others.shots)
    if (std::none_of(run.shots.begin(), run.shots.end(), [&](const auto& one) { return one.name() == other.name(); }))
      names.push_back(other.name());
  return names;
}

// Options that differ, with their values in `other`. A missing option has its default: it was not set, or the other
// revision does not have it.
static std::string otherOptions(const Json& shot, const Json& other) {
  const Json defaults = lab::toJson(lab::Shot());
  auto valueIn = [&](const Json& from, const std::string& name) {
    return from.contains(name) ? from[name] : defaults.value(name, Json());
  };
  std::set<std::string> names;
  for (const Json* json : {&shot, &other})
    for (const auto& [name, value] : json->items()) names.insert(name);
  std::vector<std::string> texts;
  for (const std::string& name : names)
    if (valueIn(shot, name) != valueIn(other, name)) texts.push_back(name + " " + valueIn(other, name).dump());
  return fmt::format("{}", fmt::join(texts, ", "));
}

void requireSameShots(const Run& run, const Run& other, const std::string& file) {
  std::vector<std::string> missing = lackingIn(other, run), besides = lackingIn(run, other), wrong;
  if (!missing.empty()) wrong.push_back(fmt::format("it has no '{}'", fmt::join(missing, "', '")));
  if (!besides.empty()) wrong.push_back(fmt::format("it also has '{}'", fmt::join(besides, "', '")));
  for (size_t i = 0; i < run.shots.size() && wrong.empty(); ++i) {
    if (run.shots[i].name() != other.shots[i].name()) wrong.push_back("the shots are in another order");
    else if (std::string differ = otherOptions(run.shots[i].shot, other.shots[i].shot); !differ.empty())
      wrong.push_back(fmt::format("'{}' has other options: {}", run.shots[i].name(), differ));
  }
  if (!wrong.empty())
    throw Error(fmt::format("a run of other shots cannot be compared: {}", fmt::join(wrong, "; ")), {file});
}

}  // namespace strobe::bench
