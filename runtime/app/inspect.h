// SPDX-License-Identifier: MIT
// `strobe check`, `strobe plan`, `strobe doctor`: what scripts, graphs and machines are like, before drawing anything.
#pragma once

#include <CLI/CLI.hpp>

namespace strobe::app {
void registerCheck(CLI::App& program);
void registerPlan(CLI::App& program);
void registerDoctor(CLI::App& program);
}  // namespace strobe::app
