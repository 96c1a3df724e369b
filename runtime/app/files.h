// SPDX-License-Identifier: MIT
// Files that commands are told about.
#pragma once

#include <string>

#include "base/home.h"

namespace strobe::app {

// `file`, or that of this name in the home where there is none here.
std::string hereOrAtHome(const Home& home, const std::string& file);

// Throws `Error` (exit code 2) for a folder that cannot be written to, before anything is rendered or made.
void requireWritable(const Path& folder, const std::string& option = "--out");

// Whether a script is a preset (scripts/strobe/preset.lua), by its text.
bool isPreset(const Home& home, const Path& file);

}  // namespace strobe::app
