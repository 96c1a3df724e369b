// SPDX-License-Identifier: MIT
// Data of a run of `strobe bench frames`: milliseconds of each shot and of its passes by round, bytes and rays of the
// passes, and the device. A run that is read from a file equals the written run.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/json.h"
#include "math/statistics.h"

namespace strobe::bench {

// Measurements of one pass in a frame: milliseconds by round, executions, bytes of traffic, and rays.
struct PassTimes {
  std::string name;                            // node name
  std::vector<double> ms;                      // by round; sum over all executions in a frame
  int executions = 0;                          // in a frame
  uint64_t bytes_read = 0, bytes_written = 0;  // in a frame: plan/traffic.h times the executions
  uint64_t rays = 0;                           // in a frame

  uint64_t bytes() const { return bytes_read + bytes_written; }
};

// Bytes and rays of all passes.
uint64_t bytesOf(const std::vector<PassTimes>& passes);
uint64_t raysOf(const std::vector<PassTimes>& passes);

// Part of a frame that belongs to no pass: building acceleration structures, clearing images.
inline constexpr const char* kRest = "(rest)";

// Times of a shot. The shot is drawn once per round. Scene, size and method identify it within a run.
struct ShotTimes {
  std::string scene, method;  // as on the command line
  int width = 0, height = 0;
  Json shot;                        // lab::toJson
  std::vector<double> ms;           // frame time by round
  std::vector<double> interval_ms;  // frame to frame, by round; empty unless several frames are in flight
  std::vector<PassTimes> passes;    // in the order of execution

  std::string size() const;   // "320x180"
  std::string place() const;  // "living_room, 320x180": the same for all shots that are compared
  std::string name() const;   // "METHOD, living_room, 320x180"
  // The passes, then kRest. Their milliseconds add up to the frame time in each round. If passes overlap on the device,
  // kRest is 0 and the sum may be larger than the frame time. Empty if no pass is timed.
  std::vector<PassTimes> parts() const;
  // Round with the frame time nearest to the median.
  size_t typicalRound() const;
};

// One run of a benchmark: the times of all shots, with the program, the device and the driver.
struct Run {
  std::string command;
  std::string version, program;  // Strobe's version, hash of its file
  std::string device, driver, backend;
  bool software = false;
  unsigned threads = 0;                            // of the processor
  std::map<std::string, std::string> environment;  // variables that change the speed of a software device
  std::vector<ShotTimes> shots;                    // by scene, then by size; the first method of each is the base
  size_t frames_in_flight = 1;                     // frames that are drawn at once

  // A software device stamps a pass when it receives the pass's commands, not when it executes them. With several
  // frames in flight, passes are therefore not timed.
  bool timesPasses() const { return !software || frames_in_flight == 1; }
  // Base of the ratios of a shot: the first shot of the same scene and size.
  const ShotTimes& baseOf(const ShotTimes& shot) const;
};

// Frame time divided by the frame time of the base in the same round.
Estimate ratioToBase(const Run& run, const ShotTimes& shot);

// Joins consecutive blocks of rounds. All blocks have the same shots and passes.
Run joined(const std::vector<Run>& blocks);

Json toJson(const Run& run);
// Throws `Error` naming the file if `json` is not a run, or if its lists differ in length.
Run runFrom(const Json& json, const std::string& file);
Run readRun(const std::string& file);

// Throws `Error` naming the differences if the shots of `other`, read from `file`, are not the shots of `run` with the
// same options. Times may differ.
void requireSameShots(const Run& run, const Run& other, const std::string& file);

}  // namespace strobe::bench
