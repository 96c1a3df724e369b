// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

// `bench frames`: what a frame of each method costs (docs/benchmarks.md).
void registerBenchFrames(CLI::App& bench, const Home& home);

}  // namespace strobe::app
