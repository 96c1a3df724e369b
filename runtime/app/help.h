// SPDX-License-Identifier: MIT
// `strobe help`: the reference page of a pass, a pipeline or a parameter.
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {
void registerHelp(CLI::App& program, const Home& home);
}  // namespace strobe::app
