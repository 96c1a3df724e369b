// SPDX-License-Identifier: MIT
#pragma once

namespace strobe::shader {

// Reads what the compiler knows of the language, which the first shaders would otherwise wait for; from any thread.
void startCompiler();

}  // namespace strobe::shader
