// SPDX-License-Identifier: MIT
// Runs another program and waits for its end, with input, environment and limits, and collects its output.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/files.h"

namespace strobe {

// Child process to run: arguments, environment, input, and limits on time and output.
struct Program {
  // The first argument is the program: a path, or a name in PATH.
  std::vector<std::string> arguments;
  // "NAME=value", replacing variables of this process with the same names. The child inherits all other variables.
  std::vector<std::string> environment;
  // Stdin of the child, piece by piece; an empty function for no input. Called when the child has read all earlier
  // pieces; an empty piece is the end. An exception ends the child, and `run` rethrows it.
  std::function<std::string()> input;
  // Destination of stderr: `errors` of the end, the output, or the stderr of this process.
  enum class Errors { apart, with_output, inherited };
  Errors errors = Errors::apart;

  // Limit of wall-clock time, at which the whole process group of the child is killed; 0: no limit.
  double wall_s = 0;
  // Bytes kept of each stream. A child that writes more is killed, or with `drops_rest` continues and the rest is
  // dropped.
  size_t output_bytes = size_t{64} << 20;
  bool drops_rest = false;

  // Called at least every 20 ms while the child runs.
  std::function<void()> meanwhile;
};

// Result of a finished child process: its output, exit status or signal, exceeded limits, and duration in seconds.
struct ProgramEnd {
  std::string output, errors;
  int exit_status = 0;  // if it ended without a signal
  int signal = 0;       // signal that ended it, or 0
  bool timed_out = false;
  bool too_long = false;  // output exceeded output_bytes
  double seconds = 0;

  // Exit code of a shell: the exit status, or 128 + signal.
  int code() const { return signal ? 128 + signal : exit_status; }
  bool succeeded() const { return code() == 0 && !timed_out; }
};

// Runs the program until it has closed its streams and has ended. The child leads its own process group. It is killed
// if this process ends first. Throws `Error` if the program cannot be started.
ProgramEnd run(const Program& program);

}  // namespace strobe
