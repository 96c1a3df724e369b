// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace strobe::app {

// `strobe mutate`.
void registerMutate(CLI::App& program);

}  // namespace strobe::app
