// SPDX-License-Identifier: MIT
// Names in the two roots of a project: for checks and for messages.
#pragma once

#include <string>
#include <vector>

#include "base/home.h"

namespace strobe {

// Mistakes of names in scripts and shaders of the project, if there is one: a shipped name without "replaces = true",
// or that line without a shipped name.
std::vector<std::string> misnamedInProject(const Home& home);

// "/p/shaders or /s/shaders", for messages on missing files.
std::string placesText(const Home& home, const Path& folder);

}  // namespace strobe
