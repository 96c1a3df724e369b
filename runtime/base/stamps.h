// SPDX-License-Identifier: MIT
// Test if files changed since they were read, without reading them again.
#pragma once

#include "base/files.h"

namespace strobe {

// Size, inode and time of the last change of files and folders. A file that changed within the last 50 ms may change
// again within the same tick of the clock, and does not count as current.
class Stamps {
 public:
  // Stores the present state. The path may be missing.
  void add(const Path& path);
  bool current() const;

 private:
  struct Stamp {
    Path path;
    uint64_t inode = 0;
    int64_t bytes = -1, changed_ns = 0;
    bool settled = true;
    bool operator==(const Stamp&) const = default;
  };
  static Stamp stampOf(const Path& path);

  std::vector<Stamp> stamps_;
};

}  // namespace strobe
