// SPDX-License-Identifier: MIT
// `strobe complete LINE`: completions of the last word of a command line. Called by completion.bash.
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

void registerCompletion(CLI::App& program, const Home& home);

}  // namespace strobe::app
