// SPDX-License-Identifier: MIT
#pragma once

#include "base/home.h"

namespace strobe::shader {

// Initialises the compiler's language tables, so that the first shaders need not wait. Thread-safe. Does nothing if the
// cache has shaders of earlier runs.
void startCompiler(const Home& home);

}  // namespace strobe::shader
