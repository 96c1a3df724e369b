// SPDX-License-Identifier: MIT
// Temporary files and folders of processes that were killed: ".inputs_N" (FrozenHome), ".recorded.PID", "NAME.PID.part"
// (writeFileAtomically, TemporaryFile).
#pragma once

#include <string>

#include "base/files.h"

namespace strobe {

// Removes those whose process is gone from a folder and the folders in it. `.inputs_N` names no process: none that
// makes such folders may be at work there.
void removeLeftovers(const Path& folder);

// Removes files and folders whose process is gone and whose names begin with `beginning`, from `folder` alone.
void removeLeftovers(const Path& folder, const std::string& beginning);

}  // namespace strobe
