// SPDX-License-Identifier: MIT
// `strobe compare TEST REFERENCE`: error metrics of two images.
#pragma once

#include <CLI/CLI.hpp>

namespace strobe::app {

// Adds the command. Its callback throws `Error` while the command line is parsed.
void registerCompare(CLI::App& program);

}  // namespace strobe::app
