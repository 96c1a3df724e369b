// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>

#include "app/commands.h"
#include "app/result_files.h"
#include "base/numbers.h"
#include "study/store.h"
#include "study/worker.h"

namespace strobe::app {

namespace {

struct StatusOptions {
  std::string folder;
  bool watch = false, json = false;
};

// Progress of a sweep: its points drawn so far, and the programs that draw.
struct Status {
  study::Results results;
  std::vector<study::WorkerState> workers;

  size_t running() const;
  size_t drawn() const;            // points, without truths
  double pointsPerSecond() const;  // of all running programs
  double secondsLeft() const;      // until every point is drawn; 0: unknown
};

Status statusOf(const Path& folder) {
  return {study::resultsSoFar(resultsFile(folder, namesIn(folder))), study::workersIn(folder)};
}

size_t Status::running() const {
  return size_t(std::count_if(workers.begin(), workers.end(), [](const auto& worker) { return worker.isRunning(); }));
}

size_t Status::drawn() const {
  size_t count = 0;
  for (const study::PointGroup& group : results.groups)
    for (const study::Point& point : group.points) count += point.role != study::ArmRole::truth && point.isDrawn();
  return count;
}

double Status::pointsPerSecond() const {
  double rate = 0;
  for (const study::WorkerState& worker : workers) rate += worker.isRunning() ? worker.pointsPerSecond() : 0;
  return rate;
}

double Status::secondsLeft() const {
  const double rate = pointsPerSecond();
  return rate > 0 ? double(results.missing()) / rate : 0;
}

// Calls `visit(group, point)` for each failed point.
template <class Visit>
void forFailed(const study::Results& results, const Visit& visit) {
  for (const study::PointGroup& group : results.groups)
    for (const study::Point& point : group.points)
      if (!point.failed.empty()) visit(group, point);
}

std::string timeText(double time_s) {
  const std::time_t time = std::time_t(time_s);
  char text[32] = "";
  std::strftime(text, sizeof text, "%F %T", std::localtime(&time));
  return text;
}

std::string textOf(const study::WorkerState& worker) {
  const std::string share = worker.share.empty() ? "" : ", share " + worker.share;
  if (!worker.isRunning())
    return fmt::format("lost     {}{}, no sign for {:.0f} s", worker.name, share, worker.silent_s);
  return fmt::format("running  {}{} on {}, since {}, {}, {:.3g} per second{}", worker.name, share, worker.device,
                     timeText(worker.since_s), countText(worker.drawn, "point"), worker.pointsPerSecond(),
                     worker.now.empty() ? "" : ": " + worker.now);
}

std::string textOf(const Status& status) {
  const study::Results& results = status.results;
  std::string text =
      fmt::format("{}: {} of {} drawn, {} missing, {} failed", results.title, results.points() - results.missing(),
                  countText(results.points(), "point"), results.missing(), results.failed().size());
  if (status.secondsLeft() > 0) text += fmt::format("; about {:.0f} s left", status.secondsLeft());
  text += "\n";
  for (const study::WorkerState& worker : status.workers) text += textOf(worker) + "\n";
  forFailed(results, [&](const study::PointGroup& group, const study::Point& point) {
    const bool is_aside = point.tries.size() >= study::kMostTries;
    text += fmt::format("failed   {}{}\n", describe(group, point),
                        is_aside ? fmt::format(" ({} tries; set aside)", point.tries.size()) : "");
  });
  return text;
}

Json jsonOf(const study::WorkerState& worker) {
  return {{"process", worker.name},
          {"running", worker.isRunning()},
          {"share", worker.share},
          {"device", worker.device},
          {"since", timeText(worker.since_s)},
          {"drawn", worker.drawn},
          {"points_per_second", study::numberJson(worker.pointsPerSecond())},
          {"now", worker.now},
          {"silent_s", study::numberJson(worker.silent_s)}};
}

Json jsonOf(const Status& status) {
  const study::Results& results = status.results;
  Json json = {{"title", results.title},
               {"points", results.points()},
               {"drawn", status.drawn()},
               {"missing", results.missing()},
               {"left_s", study::numberJson(status.secondsLeft())},
               {"programs", Json::array()},
               {"failed", Json::array()}};
  for (const study::WorkerState& worker : status.workers) json["programs"].push_back(jsonOf(worker));
  forFailed(results, [&](const study::PointGroup& group, const study::Point& point) {
    json["failed"].push_back({{"point", describe(group, point)}, {"key", point.key}, {"tries", point.tries}});
  });
  return json;
}

void show(const StatusOptions& options) {
  constexpr unsigned kBetween_s = 2;
  for (;;) {
    const Status status = statusOf(options.folder);
    std::fputs((options.json ? jsonOf(status).dump(1) + "\n" : textOf(status)).c_str(), stdout);
    std::fflush(stdout);
    if (!options.watch || (status.results.missing() == 0 && status.running() == 0)) return;
    ::sleep(kBetween_s);
  }
}

}  // namespace

void registerStatus(CLI::App& program) {
  auto options = std::make_shared<StatusOptions>();
  CLI::App* command =
      program.add_subcommand("status", "Show the progress of a sweep, and the programs that draw its points");
  command->add_option("folder", options->folder, "folder of `sweep -o`")->required();
  command->add_flag("--watch", options->watch, "repeat every two seconds until all points are drawn");
  command->add_flag("--json", options->json, "print the progress as JSON");
  command->callback([options] { show(*options); });
}

}  // namespace strobe::app
