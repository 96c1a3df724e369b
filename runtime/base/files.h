// SPDX-License-Identifier: MIT
// Files: whole reads, and the one routine through which every output is written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/error.h"

namespace strobe {

using Path = std::filesystem::path;

// The whole file. Throws `Error` naming the file and the system's reason.
std::string readText(const Path& file);
std::vector<uint8_t> readBytes(const Path& file);

// A file that cannot be written: no permission, no space.
struct WriteError : Error {
  using Error::Error;
};

// Writes to a temporary name beside `file`, flushes to disk, renames, and flushes the folder: the file is either whole
// or as it was. Creates missing folders. Throws `WriteError` with the system's reason and leaves nothing behind.
// `Flush::no` does not wait for the disk: whole after the death of the process, but not of the machine.
enum class Flush { yes, no };
void writeFileAtomically(const Path& file, std::string_view bytes, Flush flush = Flush::yes);
void writeFileAtomically(const Path& file, const std::vector<uint8_t>& bytes);

// Flushes a folder ("": the current one) to disk, so that a file that was renamed into it keeps its name when the
// machine fails. Returns the system's reason where it fails.
std::error_code flushFolder(const Path& folder);

// Names of the files in `folder` that end in `extension` (".lua"), without it, sorted; empty where there is no folder.
std::vector<std::string> namesIn(const Path& folder, std::string_view extension);

}  // namespace strobe
