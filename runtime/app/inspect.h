// SPDX-License-Identifier: MIT
// `strobe check`, `strobe plan`, `strobe doctor`: checks of scripts, graphs and the machine, without drawing.
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {
void registerCheck(CLI::App& program, const Home& home);
void registerPlan(CLI::App& program, const Home& home);
void registerDoctor(CLI::App& program, const Home& home);
}  // namespace strobe::app
