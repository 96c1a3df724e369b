// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

// `bench slopes`: how the time of a frame follows what it has (docs/benchmarks.md).
void registerBenchSlopes(CLI::App& bench, const Home& home);

}  // namespace strobe::app
