// SPDX-License-Identifier: MIT
#include "bench/measure.h"

#include <cstdlib>
#include <limits>
#include <sstream>

#include "base/cores.h"
#include "base/process.h"
#include "base/version.h"
#include "lab/record.h"
#include "lab/shot_options.h"

namespace strobe::bench {

lab::Arm methodFrom(const std::string& text) {
  size_t colon = text.find(':');
  lab::Arm method{text, text.substr(0, colon), {}};
  std::string sets = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (method.pipeline.empty() || (colon != std::string::npos && sets.empty()))
    throw Error(fmt::format("'{}' is not PIPELINE or PIPELINE:NAME=VALUE,NAME=VALUE", text), {}, 2);
  std::istringstream parts(sets);
  for (std::string part; std::getline(parts, part, ',');)
    method.sets.push_back(script::settingFromText(part, fmt::format("'{}':", text)));
  return method;
}

namespace {

// Variables that change the speed of a software device.
std::map<std::string, std::string> driverEnvironment() {
  std::map<std::string, std::string> found;
  for (const char* name : {"GALLIVM_PERF", "LP_NATIVE_VECTOR_WIDTH", "LP_NUM_THREADS"})
    if (const char* value = std::getenv(name)) found[name] = value;
  return found;
}

lab::Shot shotOf(const Subject& subject, const std::string& scene, const std::array<int, 2>& size,
                 const lab::Arm& method) {
  lab::Shot shot = subject.shot;
  shot.scene = scene;
  shot.width = size[0], shot.height = size[1];
  shot.pipeline = method.pipeline;
  for (const auto& [name, value] : method.sets) lab::putSetting(shot.sets, name, value);
  return shot;
}

// Shots with all options filled in, and their run without times.
struct PreparedRun {
  std::vector<lab::Shot> shots;
  Run run;
};

// Throws `Error` with exit code 2 if a method does not accept its settings.
void requirePlan(lab::Batch& batch, const lab::Shot& shot, const std::string& method) {
  try {
    batch.planOf(shot);
  } catch (const lab::Refusal& refusal) {
    throw Error(fmt::format("method '{}': {}", method, refusal.message()), {}, 2);
  }
}

PreparedRun prepared(lab::Batch& batch, const std::vector<NamedShot>& shots) {
  lab::Workbench& bench = batch.bench();
  const gpu::DeviceInfo& device = bench.device().info();
  PreparedRun result;
  result.run = {"", kVersion, lab::programHash(), device.name, device.driver};
  result.run.backend = shader::backendName(bench.chooseBackend(shots.front().shot.backend));
  result.run.software = device.software;
  result.run.frames_in_flight = bench.frames_in_flight;
  result.run.threads = allowedCores();
  result.run.environment = driverEnvironment();
  for (const NamedShot& named : shots) {
    lab::Shot shot = batch.filled(named.shot);
    requirePlan(batch, shot, named.method);
    result.run.shots.push_back({named.scene, named.method, shot.width, shot.height, lab::toJson(shot)});
    result.shots.push_back(std::move(shot));
  }
  return result;
}

// Adds bytes and rays of the last frame.
void addWork(std::vector<PassTimes>& passes, const plan::Plan& plan, const lab::Timing& timing) {
  std::map<std::string, plan::Traffic> traffic = trafficByPass(plan);
  for (size_t i = 0; i < passes.size(); ++i) {
    PassTimes& pass = passes[i];
    pass.executions = timing.executions[i];
    pass.bytes_read = traffic[pass.name].read * uint64_t(pass.executions);
    pass.bytes_written = traffic[pass.name].written * uint64_t(pass.executions);
    for (const auto& [name, count] : timing.counters)
      if (name.starts_with(pass.name + ".rays_")) pass.rays += count;
  }
}

}  // namespace

std::map<std::string, plan::Traffic> trafficByPass(const plan::Plan& plan) {
  std::vector<plan::Traffic> traffic = plan::trafficOf(plan);
  std::map<std::string, plan::Traffic> by_name;
  for (size_t i = 0; i < traffic.size(); ++i)
    by_name[plan.pipeline.nodes[size_t(plan.nodes[i].node)].name] = traffic[i];
  return by_name;
}

std::vector<NamedShot> shotsOf(const Subject& subject) {
  std::vector<NamedShot> shots;
  for (const std::string& scene : subject.scenes)
    for (const std::array<int, 2>& size : subject.sizes)
      for (const lab::Arm& method : subject.methods)
        shots.push_back({scene, method.name, shotOf(subject, scene, size, method)});
  return shots;
}

Run outlineOf(lab::Workbench& bench, const std::vector<NamedShot>& shots) {
  lab::Batch batch(bench);
  return prepared(batch, shots).run;
}

Run measure(lab::Workbench& bench, const std::vector<NamedShot>& shots, const lab::Rounds& rounds) {
  lab::Batch batch(bench);
  PreparedRun of = prepared(batch, shots);
  // Keep every graph: a new graph would allocate its memory again in each round.
  batch.drawings.most = of.shots.size();
  batch.drawings.most_bytes = std::numeric_limits<size_t>::max();
  std::vector<lab::Timing> timings = batch.timeInTurn(of.shots, rounds);
  for (size_t i = 0; i < timings.size(); ++i) {
    ShotTimes& shot = of.run.shots[i];
    shot.ms = timings[i].ms;
    if (bench.frames_in_flight > 1) shot.interval_ms = timings[i].interval_ms;
    if (!of.run.timesPasses()) continue;
    for (const auto& [name, ms] : timings[i].passes) shot.passes.push_back({name, ms});
    addWork(shot.passes, *batch.planOf(of.shots[i]), timings[i]);
  }
  return of.run;
}

// ---- two programs

// Last line of a program's output, with the reason of its end.
static std::string lastLine(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

static Run runOf(const std::string& program, const std::vector<std::string>& arguments) {
  Program child{.arguments = {program}};
  child.arguments.insert(child.arguments.end(), arguments.begin(), arguments.end());
  ProgramEnd end = run(child);
  if (!end.succeeded())
    throw Error(fmt::format("cannot run these shots: exit code {}, '{}'", end.code(), lastLine(end.errors)), {program});
  return runFrom(Json::parse(end.output, nullptr, false), program + " bench frames");
}

Turns runInTurn(const std::string& first, const std::string& second, const std::vector<std::string>& arguments,
                int blocks, const std::function<void(int done)>& progress) {
  Turns turns;
  for (int block = 0; block < blocks; ++block) {
    for (int turn = 0; turn < 2; ++turn) {
      bool is_first = turn == block % 2;
      (is_first ? turns.first : turns.second).push_back(runOf(is_first ? first : second, arguments));
    }
    requireSameShots(turns.first.back(), turns.second.back(), second);
    progress(block + 1);
  }
  return turns;
}

}  // namespace strobe::bench
