// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

// Registers `bench frames`: frame time of each method (docs/benchmarks.md).
void registerBenchFrames(CLI::App& bench, const Home& home);

}  // namespace strobe::app
