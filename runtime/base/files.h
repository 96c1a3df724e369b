// SPDX-License-Identifier: MIT
// Files: whole reads, and the one routine that writes every output.
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

// Content of the whole file. Throws `Error` naming the file and the system's reason.
std::string readText(const Path& file);
std::vector<uint8_t> readBytes(const Path& file);

// A file that cannot be written: no permission, no space.
struct WriteError : Error {
  using Error::Error;
};

// Waiting for the disk after a write. With `no`, the file is complete after a crash of the process, but not of the
// machine.
enum class Flush { yes, no };

// Writes to a temporary name beside `file`, flushes to disk, renames, and flushes the folder: the file is either
// complete or unchanged. Creates missing folders. Throws `WriteError` with the system's reason and leaves nothing
// behind.
void writeFileAtomically(const Path& file, std::string_view bytes, Flush flush = Flush::yes);
void writeFileAtomically(const Path& file, const std::vector<uint8_t>& bytes);

// Flushes a folder ("": the current one) to disk, so that a renamed file keeps its name if the machine fails. Returns
// the system's reason if the flush fails.
std::error_code flushFolder(const Path& folder);

// True if the name ends in `extension` (".lua"), ignoring case.
bool hasExtension(std::string_view name, std::string_view extension);

// Sorted names of the files in `folder` with this extension (".lua"), without the extension. Empty if the folder is
// missing.
std::vector<std::string> namesIn(const Path& folder, std::string_view extension);

}  // namespace strobe
