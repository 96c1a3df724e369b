// SPDX-License-Identifier: MIT
// The source folder, read by tests. A function, so that no other object depends on its path.
#pragma once

#include "base/files.h"

namespace strobe {

Path sourceFolder();

}  // namespace strobe
