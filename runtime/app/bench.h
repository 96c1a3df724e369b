// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

// Registers `strobe bench` with `reload`, `frames` and `slopes`.
void registerBench(CLI::App& program, const Home& home);

}  // namespace strobe::app
