// SPDX-License-Identifier: MIT
// A capture as one file.
#pragma once

#include "base/files.h"

namespace strobe::archive {

// "out/x.zip" beside a folder "out/x" or "out/x/"; absolute.
Path zipBeside(const Path& folder);

// Writes the files that the folder's SHA256SUMS lists, that itself and the crate, by their names in the folder. The
// same files give the same bytes: names are sorted, times are 1980-01-01, permissions rw-r--r--. The zip is whole, or
// as it was. Throws `Error` where a listed file cannot be read, `WriteError` with the reason where the zip cannot be
// written.
void writeZip(const Path& folder, const Path& zip);

}  // namespace strobe::archive
