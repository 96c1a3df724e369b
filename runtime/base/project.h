// SPDX-License-Identifier: MIT
// File names in the two roots of a project, for checks and messages.
#pragma once

#include <string>
#include <vector>

#include "base/home.h"

namespace strobe {

// Mistakes in the names of the project's scripts and shaders, if there is a project: a shipped name without "replaces =
// true", or that line without a shipped name.
std::vector<std::string> misnamedInProject(const Home& home);

// "/p/shaders or /s/shaders", for messages on missing files.
std::string placesText(const Home& home, const Path& folder);

}  // namespace strobe
