// SPDX-License-Identifier: MIT
// Processes that evaluate scripts, on the side of the program. A server (`strobe --script-child`) starts with the first
// request, and forks for each request. The first fork for a pipeline file loads the file; later requests for the file
// fork from this process, while no loaded file changes.
#pragma once

#include <string>

#include "base/home.h"
#include "base/process.h"

namespace strobe::script {

// Exit status of a process that could not allocate memory for its answer.
inline constexpr int kOutOfMemory = 4;

// Name of the file in requests that do not fork from a process with a loaded file.
inline constexpr const char* kNoFile = "-";

// Starts the server for the roots of `home`, if it does not run. A later request then does not wait for the start.
void startServer(const Home& home);

// End of the process that evaluated the request, with its answer. `file` is the same for all requests that load the
// same file, or `kNoFile`. The process ends itself after `wall_s`. Throws `Error` if the server cannot be started, or
// twice ends without an answer. Thread-safe.
ProgramEnd answerTo(const Home& home, const std::string& file, const std::string& request, double wall_s);

}  // namespace strobe::script
