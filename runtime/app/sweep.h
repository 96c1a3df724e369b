// SPDX-License-Identifier: MIT
// `strobe sweep`: runs an experiment. `strobe report`: lays out its results again. `strobe demo`: takes a capture and
// measures it.
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

void registerSweep(CLI::App& program, const Home& home);
void registerReport(CLI::App& program, const Home& home);
void registerDemo(CLI::App& program, const Home& home);

}  // namespace strobe::app
