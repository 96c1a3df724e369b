// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

// Registers `bench slopes`: growth of the frame time along one axis at a time (docs/benchmarks.md).
void registerBenchSlopes(CLI::App& bench, const Home& home);

}  // namespace strobe::app
