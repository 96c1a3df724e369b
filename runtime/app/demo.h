// SPDX-License-Identifier: MIT
// `strobe demo`: shots and columns of a demo file as a contact sheet, a page and tables.
#pragma once

#include <CLI/CLI.hpp>

namespace strobe::app {

void registerDemo(CLI::App& program);

}  // namespace strobe::app
