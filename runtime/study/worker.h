// SPDX-License-Identifier: MIT
// Programs that work in the folder of a sweep: each one keeps a file about itself, which `strobe status` reads.
#pragma once

#include "base/lease.h"

namespace strobe::study {

// State of a program that works in the folder of a sweep.
struct WorkerState {
  std::string name;      // HOST.PID
  std::string device;    // name of the Vulkan device
  std::string share;     // "2/8"; "": all points
  std::string version;   // hash of program and inputs
  std::string now;       // point that is drawn; "": none
  double since_s = 0;    // start, Unix time
  size_t drawn = 0;      // points drawn so far, without truths
  double drawing_s = 0;  // time spent on these points
  double silent_s = 0;   // time since the last sign; only read, not written

  bool isRunning() const;
  double pointsPerSecond() const { return drawing_s > 0 ? double(drawn) / drawing_s : 0; }
};

// States of all programs that have not removed their files.
std::vector<WorkerState> workersIn(const Path& folder);

// True if a program works in the folder.
bool isUsed(const Path& folder);

// Removes the files of ended processes of this machine.
void removeEndedWorkers(const Path& folder);

// Mean time of a point drawn in this folder, seconds; 0 if unknown.
double secondsPerPoint(const Path& folder);

// Sign of this program in the folder of a sweep: FOLDER/.workers/HOST.PID.json, until the object is destroyed.
class Worker {
 public:
  Worker(const Path& folder, WorkerState state);
  Worker(const Worker&) = delete;
  ~Worker();

  const WorkerState& state() const { return state_; }
  void begin(const std::string& point);
  void reach(size_t drawn, double drawing_s);  // points so far, without truths, and the time spent

 private:
  void write();

  const Path folder_, file_;
  WorkerState state_;
  double written_s_ = 0;
  Heartbeat heartbeat_;
};

}  // namespace strobe::study
