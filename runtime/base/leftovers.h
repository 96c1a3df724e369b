// SPDX-License-Identifier: MIT
// Temporary files and folders of processes that were killed: ".inputs.HOST.PID" and ".inputs_N.HOST.PID" (FrozenHome),
// ".recorded.HOST.PID", "NAME.HOST.PID.part" (writeFileAtomically, TemporaryFile).
#pragma once

#include <string>

#include "base/files.h"

namespace strobe {

// Removes leftovers of ended processes of this machine from a folder and the folders in it. Files of running processes
// and of other machines stay.
void removeLeftovers(const Path& folder);

// Removes such leftovers from `folder` only, if their names begin with `beginning`.
void removeLeftovers(const Path& folder, const std::string& beginning);

}  // namespace strobe
