// SPDX-License-Identifier: MIT
// Files and folders named on the command line.
#pragma once

#include <string>

#include "base/home.h"

namespace strobe::app {

// `file` if it exists or is absolute, else the file of this name in the home, else `file`.
std::string hereOrAtHome(const Home& home, const std::string& file);

// Throws `Error` (exit code 2) if the folder is not writable. Call before anything is rendered or created.
void requireWritable(const Path& folder, const std::string& option = "--out");

// True if the script requires strobe.preset (scripts/strobe/preset.lua).
bool isPreset(const Home& home, const Path& file);

}  // namespace strobe::app
