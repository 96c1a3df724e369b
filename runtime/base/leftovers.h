// SPDX-License-Identifier: MIT
// Temporary files and folders of processes that were killed: ".inputs_N" (FrozenHome), ".recorded.PID", "NAME.PID.part"
// (writeFileAtomically, TemporaryFile).
#pragma once

#include <string>

#include "base/files.h"

namespace strobe {

// Removes leftovers of ended processes from a folder and the folders in it. `.inputs_N` does not name its process: no
// process that creates such folders may be running there.
void removeLeftovers(const Path& folder);

// Removes leftovers of ended processes from `folder` only, if their names begin with `beginning`.
void removeLeftovers(const Path& folder, const std::string& beginning);

}  // namespace strobe
