// SPDX-License-Identifier: MIT
// A file that a library or another program writes under a temporary name. It gets its final name when it is complete.
#pragma once

#include "base/files.h"

namespace strobe {

// "FILE.HOST.PID.part" beside a file. The destructor removes it unless it was kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(Path file);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  const Path& path() const { return path_; }

  // Flushes to disk, renames to the final name, and flushes the folder. Throws `WriteError` with the system's reason.
  void keep();

 private:
  const Path file_, path_;
};

}  // namespace strobe
