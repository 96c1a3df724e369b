// SPDX-License-Identifier: MIT
// Version of the program.
#pragma once

namespace strobe {

extern const char* const kVersion;  // "1.2.3"

}  // namespace strobe
