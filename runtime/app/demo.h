// SPDX-License-Identifier: MIT
// `strobe demo`: shots and columns of a demo file as a contact sheet, a page and tables.
#pragma once

#include <CLI/CLI.hpp>

#include "base/home.h"

namespace strobe::app {

void registerDemo(CLI::App& program, const Home& home);

}  // namespace strobe::app
