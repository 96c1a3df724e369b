// SPDX-License-Identifier: MIT
// The long suites have a short form, a part of their cases, and a long form with all cases.
#pragma once

#include <cstdlib>

namespace strobe {

// True under `./strobe test --all`: run the long form.
inline bool allCases() { return std::getenv("STROBE_TEST_ALL") != nullptr; }

}  // namespace strobe
