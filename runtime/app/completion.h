// SPDX-License-Identifier: MIT
// `strobe complete LINE`: what the last word of a command line may become. completion.bash asks it.
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

void registerCompletion(CLI::App& program, const Home& home);

}  // namespace strobe::app
