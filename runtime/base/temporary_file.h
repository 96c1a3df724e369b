// SPDX-License-Identifier: MIT
// A file that a library or another program writes, which gets its name when it is whole.
#pragma once

#include "base/files.h"

namespace strobe {

// "FILE.PID.part" beside a file; removed unless it was kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(Path file);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  const Path& path() const { return path_; }

  // Flushes to disk, renames to the file, and flushes the folder. Throws `WriteError` with the system's reason.
  void keep();

 private:
  const Path file_, path_;
};

}  // namespace strobe
