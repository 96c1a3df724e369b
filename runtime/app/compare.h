// SPDX-License-Identifier: MIT
// `strobe compare TEST REFERENCE`: error metrics of two images.
#pragma once

#include <CLI/CLI.hpp>

namespace strobe::app {

// Adds the command and what it does to the program; it throws `Error` from within the parsing of the command line.
void registerCompare(CLI::App& program);

}  // namespace strobe::app
