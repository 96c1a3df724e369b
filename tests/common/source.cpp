// SPDX-License-Identifier: MIT
#include "common/source.h"

namespace strobe {

Path sourceFolder() { return STROBE_SOURCE_DIR; }

}  // namespace strobe
