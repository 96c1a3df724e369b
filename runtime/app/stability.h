// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

// Registers `strobe stability`.
void registerStability(CLI::App& program, const Home& home);

}  // namespace strobe::app
