// SPDX-License-Identifier: MIT
#include "base/version.h"

namespace strobe {

const char* const kVersion = STROBE_VERSION;

}  // namespace strobe
