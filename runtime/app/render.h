// SPDX-License-Identifier: MIT
// `strobe render PIPELINE --scene S -o FILE`: one picture.
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {
void registerRender(CLI::App& program, const Home& home);
}
