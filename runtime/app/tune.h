// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

// Registers `strobe tune`: best setting of a pipeline within a budget or an error, as a preset.
void registerTune(CLI::App& program, const Home& home);

}  // namespace strobe::app
