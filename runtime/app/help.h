// SPDX-License-Identifier: MIT
// `strobe help`: the reference page of a pass, a pipeline or a parameter.
#pragma once

#include <CLI/CLI.hpp>

namespace strobe::app {
void registerHelp(CLI::App& program);
}  // namespace strobe::app
