// SPDX-License-Identifier: MIT
// `strobe sweep`: runs an experiment. `strobe report`: lays its results out again. `strobe demo`: the first experiment
// that people see.
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

void registerSweep(CLI::App& program, const Home& home);
void registerReport(CLI::App& program, const Home& home);
void registerDemo(CLI::App& program, const Home& home);

}  // namespace strobe::app
