// SPDX-License-Identifier: MIT
// `strobe capture`, `verify`, `diff`: pictures that are reproducible bit for bit.
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

void registerCapture(CLI::App& program, const Home& home);

}  // namespace strobe::app
