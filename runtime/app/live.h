// SPDX-License-Identifier: MIT
// `strobe live PIPELINE --scene S`: shows a pipeline in a window.
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {
void registerLive(CLI::App& program, const Home& home);
}
