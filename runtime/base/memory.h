// SPDX-License-Identifier: MIT
// Memory of the machine that is available to this process.
#pragma once

#include "base/files.h"

namespace strobe {

// Available memory, bytes: the memory that the system has free or can free (/proc/meminfo), limited by the rest of each
// control group of the process (version 2 only). UINT64_MAX if the system states neither. `root` holds the folders
// `proc` and `sys`.
uint64_t availableMemory(const Path& root = "/");

// "1.2 GiB", "340 MiB", "96 KiB", "12 bytes".
std::string bytesText(uint64_t bytes);

}  // namespace strobe
