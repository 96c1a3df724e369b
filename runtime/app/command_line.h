// SPDX-License-Identifier: MIT
// Parses one command line and runs its command in this process.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/kept_bench.h"

namespace strobe::app {

// End of a command: exit code, and the message of a failure.
struct CommandEnd {
  int exit_code = 0;      // 0: success; 1: failure; 2: wrong command line; 75: stopped, try again
  std::string error;      // one line per mistake; "": no message
  bool is_fault = false;  // failure that is not an `Error`, such as a lost device: the process cannot continue
};

// Runs the command of `words`, the command line without the name of the program. The command prints its results to
// stdout. `accept` (may be empty) is called with the name of the command before the command runs; it throws `Error` to
// refuse the command.
CommandEnd runCommand(const Home& home, KeptBench& bench, const std::vector<std::string>& words,
                      const std::function<void(const std::string& command)>& accept = {});

}  // namespace strobe::app
