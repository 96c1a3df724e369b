// SPDX-License-Identifier: MIT
// The folder of the sources, whose files tests read. A function, so that no other object depends on where it is.
#pragma once

#include "base/files.h"

namespace strobe {

Path sourceFolder();

}  // namespace strobe
