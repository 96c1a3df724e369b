// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace strobe::app {

// `strobe bench reload`.
void registerBench(CLI::App& program);

}  // namespace strobe::app
