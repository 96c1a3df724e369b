// SPDX-License-Identifier: MIT
// Packs a capture into one file.
#pragma once

#include "base/files.h"

namespace strobe::archive {

// "out/x.zip" for a folder "out/x" or "out/x/"; absolute.
Path zipBeside(const Path& folder);

// Writes the files listed in the folder's SHA256SUMS, SHA256SUMS itself and the crate, under their names in the folder.
// The same files give the same bytes: names are sorted, times are 1980-01-01, permissions rw-r--r--. The zip is
// complete, or unchanged. Throws `Error` if a listed file cannot be read, and `WriteError` with the reason if the zip
// cannot be written.
void writeZip(const Path& folder, const Path& zip);

}  // namespace strobe::archive
