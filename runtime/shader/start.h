// SPDX-License-Identifier: MIT
#pragma once

#include "base/home.h"

namespace strobe::shader {

// Reads what the compiler knows of the language, which the first shaders would otherwise wait for; from any thread.
// Does nothing where shaders of earlier runs are kept.
void startCompiler(const Home& home);

}  // namespace strobe::shader
