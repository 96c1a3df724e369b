// SPDX-License-Identifier: MIT
#include "bench/trace.h"

#include <algorithm>

namespace strobe::bench {

static constexpr int kThread = 1;

static Json nameEvent(const char* what, int process, const std::string& name) {
  return {{"name", what}, {"ph", "M"}, {"pid", process}, {"tid", kThread}, {"args", {{"name", name}}}};
}

static Json completeEvent(const std::string& name, int process, double start_us, double length_us, const Json& args) {
  return {{"name", name},   {"ph", "X"},      {"cat", "gpu"},     {"pid", process},
          {"tid", kThread}, {"ts", start_us}, {"dur", length_us}, {"args", args}};
}

static Json argumentsOf(const PassTimes& pass) {
  return {{"executions", pass.executions},
          {"bytes_read", pass.bytes_read},
          {"bytes_written", pass.bytes_written},
          {"rays", pass.rays}};
}

static void addShot(Json& events, const ShotTimes& shot, int process) {
  const size_t round = shot.typicalRound();
  events.push_back(nameEvent("process_name", process, shot.name()));
  events.push_back(nameEvent("thread_name", process, shot.method));
  const size_t at = events.size();
  double end_us = 0;
  for (const PassTimes& part : shot.parts()) {
    double length_us = 1000 * part.ms[round];
    events.push_back(completeEvent(part.name, process, end_us, length_us, argumentsOf(part)));
    end_us += length_us;
  }
  events.insert(events.begin() + std::ptrdiff_t(at),
                completeEvent("frame", process, 0, std::max(end_us, 1000 * shot.ms[round]),
                              {{"round", round}, {"ms", shot.ms[round]}}));
}

Json traceOf(const Run& run) {
  Json trace = {{"displayTimeUnit", "ms"},
                {"otherData", {{"device", run.device}, {"driver", run.driver}, {"command", run.command}}},
                {"traceEvents", Json::array()}};
  for (size_t i = 0; i < run.shots.size(); ++i) addShot(trace["traceEvents"], run.shots[i], int(i) + 1);
  return trace;
}

}  // namespace strobe::bench
