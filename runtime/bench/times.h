// SPDX-License-Identifier: MIT
// What a run of `strobe bench frames` found, as data: milliseconds of each shot and of each of its passes by round,
// what the passes touch, and what all of it ran on. Read back from a file it is what was written.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/json.h"
#include "math/statistics.h"

namespace strobe::bench {

struct PassTimes {
  std::string name;                            // of the node
  std::vector<double> ms;                      // by round, all executions of a frame
  int executions = 0;                          // in a frame
  uint64_t bytes_read = 0, bytes_written = 0;  // in a frame: plan/traffic.h times the executions
  uint64_t rays = 0;                           // in a frame

  uint64_t bytes() const { return bytes_read + bytes_written; }
};

// What of a frame is in no pass: structures that are built, images that are cleared.
inline constexpr const char* kRest = "(rest)";

// Drawn once in every round. Scene, size and method identify it within a run.
struct ShotTimes {
  std::string scene, method;  // as the command line has them
  int width = 0, height = 0;
  Json shot;                        // lab::toJson
  std::vector<double> ms;           // of a frame, by round
  std::vector<double> interval_ms;  // from frame to frame, by round; empty unless several are under way at once
  std::vector<PassTimes> passes;    // in the order of execution

  std::string size() const;   // "320x180"
  std::string place() const;  // "living_room, 320x180": those that are compared with each other have the same
  std::string name() const;   // "METHOD, living_room, 320x180"
  // The passes and kRest, whose milliseconds add up to those of the frame in each round. (Passes that overlap on a
  // device may add up to more; the rest is 0 then.) None where no pass is timed.
  std::vector<PassTimes> parts() const;
  // The round whose frame took the time nearest to the median.
  size_t typicalRound() const;
};

struct Run {
  std::string command;
  std::string version, program;  // of Strobe, and the hash of its file
  std::string device, driver, backend;
  bool software = false;
  unsigned threads = 0;                            // of the processor
  std::map<std::string, std::string> environment;  // variables that change what a software device does
  std::vector<ShotTimes> shots;                    // by scene, then by size; the first method of each is the base
  size_t frames_in_flight = 1;                     // under way at once

  // A software device stamps passes as it takes their commands, not as it executes them: with several frames under way
  // no pass has a time, and shots have none.
  bool timesPasses() const { return !software || frames_in_flight == 1; }
  // The shot that the ratios of another are to: the first of the same scene and size.
  const ShotTimes& baseOf(const ShotTimes& shot) const;
};

// Milliseconds of the frame as multiples of the base's in the same rounds.
Estimate ratioToBase(const Run& run, const ShotTimes& shot);

// Blocks of rounds one after the other, all of the same shots and passes.
Run joined(const std::vector<Run>& blocks);

Json toJson(const Run& run);
// Throws `Error` naming the file for what is no such run, or one whose lists are not of one length.
Run runFrom(const Json& json, const std::string& file);
Run readRun(const std::string& file);

// Throws `Error` naming what differs where `other`, from `file`, has not the shots of `run`, taken alike. Times do not
// matter.
void requireSameShots(const Run& run, const Run& other, const std::string& file);

}  // namespace strobe::bench
