// SPDX-License-Identifier: MIT
// Runs another program and waits for its end: what it reads, its environment, its limits, what it wrote.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/files.h"

namespace strobe {

struct Program {
  // The first is the program: a path, or a name that PATH knows.
  std::vector<std::string> arguments;
  // "NAME=value", in place of variables of this process with these names; the child has the others too.
  std::vector<std::string> environment;
  // What the child reads on stdin.
  std::string input;
  // More of it, for what does not fit into memory at once: called when the child has taken all before; an empty text is
  // the end. What it throws ends the child and is thrown by `run`.
  std::function<std::string()> more_input;
  // Where stderr goes: into `errors` of the end, in among the output, or where this process has its own.
  enum class Errors { apart, with_output, inherited };
  Errors errors = Errors::apart;

  // Limits; 0 is none. At the wall clock's the whole process group of the child is killed; the system enforces the
  // others (SIGXCPU, memory that is not given).
  double wall_s = 0;
  double cpu_s = 0;  // in whole seconds, rounded up
  size_t memory_bytes = 0;
  // Bytes kept of each stream. A child that writes more is killed, or with `drops_rest` goes on unheard.
  size_t output_bytes = size_t{64} << 20;
  bool drops_rest = false;

  // Called every 20 ms or more often while the child runs.
  std::function<void()> meanwhile;
};

struct ProgramEnd {
  std::string output, errors;
  int exit_status = 0;  // where it ended without a signal
  int signal = 0;       // that ended it, or 0
  bool timed_out = false;
  bool too_long = false;  // it wrote more than is kept
  double seconds = 0;

  // As a shell counts: the exit status, or 128 + signal.
  int code() const { return signal ? 128 + signal : exit_status; }
  bool succeeded() const { return code() == 0 && !timed_out; }
};

// Waits until the child has closed its streams and has ended. The child leads a process group of its own and is killed
// where this process ends first. Throws `Error` where the program cannot be started.
ProgramEnd run(const Program& program);

// A program that is started before it is known what it reads, so that its start takes no time later, or that reads and
// answers again and again. It is ended with this object, unless it has ended; and, by the system, with the thread that
// made it.
class WaitingProgram {
 public:
  // Hands it `program.input` at once, which is not the last. Throws `Error` where it cannot be started.
  explicit WaitingProgram(Program program);
  WaitingProgram(WaitingProgram&&) noexcept;
  ~WaitingProgram();
  // Whether it still waits.
  bool waits() const;
  // As `run` with this input, and the last; the limit of the wall clock counts from here.
  ProgramEnd run(const std::string& input);
  // Hands it `input` and waits until `is_whole` says so of what it has written to stdout since; then it waits again.
  // Where it ends before, or exceeds a limit, it is over, as the end says. `wall_s` counts from here.
  ProgramEnd ask(const std::string& input, double wall_s,
                 const std::function<bool(const std::string& output)>& is_whole);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace strobe
