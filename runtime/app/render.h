// SPDX-License-Identifier: MIT
// `strobe render PIPELINE --scene S -o FILE`: one picture.
#pragma once

#include <CLI/CLI.hpp>

namespace strobe::app {
void registerRender(CLI::App& program);
}
