// SPDX-License-Identifier: MIT
// Orderly end of a program: after Ctrl-C, after SIGTERM of a batch system, or before a time limit.
#pragma once

#include <string>

namespace strobe {

// Exit code of a program that was stopped before its end: "try again" (EX_TEMPFAIL of sysexits.h).
inline constexpr int kTryAgain = 75;

// Thrown to stop the program. Not a `std::exception`, so that no handler of failures takes it for the failure of a
// picture.
struct Stopped {
  std::string reason;  // "interrupted", "the time is up"
  std::string kept = "the same command continues";
};

// While the object exists, the first SIGINT or SIGTERM requests a stop, and the second ends the process at once with
// exit code 75. A process that has not stopped after ten seconds ends by itself. An ignored signal stays ignored. One
// object at a time.
class Interruption {
 public:
  // `time_left_s`: seconds from now until a stop is requested; 0: no limit.
  explicit Interruption(double time_left_s = 0);
  Interruption(const Interruption&) = delete;
  ~Interruption();
};

// Throws `Stopped` if a stop was requested. For the end of a piece of work.
void stopIfRequested();
// Throws `Stopped` if a stop was requested more than two seconds ago, or the time is up. For the middle of a piece of
// work.
void stopIfOverdue();
// Throws `Stopped` if work of this duration would not be finished before the time limit.
void stopIfLonger(double seconds);

// Waits, and throws `Stopped` as soon as a stop is requested.
void waitFor(double seconds);

}  // namespace strobe
