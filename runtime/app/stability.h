// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace strobe::app {

// `strobe stability`.
void registerStability(CLI::App& program);

}  // namespace strobe::app
