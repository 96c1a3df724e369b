// SPDX-License-Identifier: MIT
// The parent's side of a script child.
#pragma once

#include <string>

namespace strobe::script {

// Exit status of a child that found no memory for its answer.
inline constexpr int kOutOfMemory = 4;

struct ChildResult {
  std::string output;
  int exit_status = 0;  // where it ended by itself
  int signal = 0;       // where a signal ended it
  bool timed_out = false;
  bool too_long = false;  // it wrote more than any description needs
};

// Starts `$STROBE_PROGRAM --script-child` (without that variable: this program), hands it `input` on stdin and waits
// for its end, `wall_s` at most. Throws `Error` where no process can be started.
ChildResult runChild(const std::string& input, double wall_s);

}  // namespace strobe::script
