// SPDX-License-Identifier: MIT
#include "study/worker.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <optional>

#include "base/json.h"
#include "base/log.h"
#include "base/process_name.h"
#include "study/store.h"

namespace strobe::study {

namespace fs = std::filesystem;

namespace {

constexpr double kBetween_s = 1;  // between two writes of a state

Path fileOf(const Path& folder, const std::string& name) { return folder / kWorkers / (name + ".json"); }

Path speedFile(const Path& folder) { return folder / kWorkers / "speed"; }

// Calls `visit(name, field)` for each field of a state's file.
template <class State, class Visit>
void forFields(State& state, const Visit& visit) {
  visit("device", state.device), visit("share", state.share), visit("version", state.version);
  visit("now", state.now), visit("since", state.since_s), visit("drawn", state.drawn);
  visit("drawing_s", state.drawing_s);
}

// Points drawn in a folder, and the time that they took.
struct Speed {
  double points = 0, seconds = 0;
};

// Zero if the file is missing or damaged.
Speed speedIn(const Path& folder) {
  try {
    const Json json = Json::parse(readText(speedFile(folder)));
    return {json.at("points"), json.at("seconds")};
  } catch (const std::exception&) {
    return {};
  }
}

// Empty if the file was just removed, or is damaged.
std::optional<WorkerState> stateIn(const Path& file) {
  try {
    const Json json = Json::parse(readText(file));
    WorkerState worker;
    worker.name = file.stem();
    forFields(worker, [&](const char* field, auto& value) { json.at(field).get_to(value); });
    return worker;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace

bool WorkerState::isRunning() const { return silent_s <= kLease_s && !hasEnded(name); }

std::vector<WorkerState> workersIn(const Path& folder) {
  std::vector<WorkerState> workers;
  const double now_s = timeIn(folder / kWorkers);
  for (const std::string& name : namesIn(folder / kWorkers, ".json"))
    if (std::optional<WorkerState> worker = stateIn(fileOf(folder, name))) {
      worker->silent_s = now_s - changedAt(fileOf(folder, name));
      workers.push_back(std::move(*worker));
    }
  return workers;
}

bool isUsed(const Path& folder) {
  const double now_s = timeIn(folder / kWorkers);
  const std::vector<std::string> names = namesIn(folder / kWorkers, ".json");
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return !hasEnded(name) && changedAt(fileOf(folder, name)) > now_s - kLease_s;
  });
}

void removeEndedWorkers(const Path& folder) {
  std::error_code ignored;
  for (const std::string& name : namesIn(folder / kWorkers, ".json"))
    if (hasEnded(name)) fs::remove(fileOf(folder, name), ignored);
}

double secondsPerPoint(const Path& folder) {
  const Speed speed = speedIn(folder);
  return speed.points > 0 ? speed.seconds / speed.points : 0;
}

Worker::Worker(const Path& folder, WorkerState state)
    : folder_(folder), file_(fileOf(folder, processName())), state_(std::move(state)), heartbeat_(file_) {
  state_.name = processName(), state_.since_s = double(std::time(nullptr));
  write();
}

// Programs that end together may lose a part of the sums, which serve an estimate.
Worker::~Worker() {
  std::error_code ignored;
  fs::remove(file_, ignored);
  if (state_.drawn == 0) return;
  const Speed speed = speedIn(folder_);
  const Json sums = {{"points", speed.points + double(state_.drawn)}, {"seconds", speed.seconds + state_.drawing_s}};
  try {
    writeFileAtomically(speedFile(folder_), sums.dump(), Flush::no);
  } catch (const std::exception&) {  // a full disk
  }
}

void Worker::write() {
  Json json;
  forFields(state_, [&](const char* field, const auto& value) { json[field] = value; });
  writeFileAtomically(file_, json.dump(), Flush::no);
}

void Worker::begin(const std::string& point) {
  state_.now = point;
  if (clockSeconds() < written_s_ + kBetween_s) return;
  write();
  written_s_ = clockSeconds();
}

void Worker::reach(size_t drawn, double drawing_s) { state_.drawn = drawn, state_.drawing_s = drawing_s; }

}  // namespace strobe::study
