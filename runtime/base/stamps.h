// SPDX-License-Identifier: MIT
// Whether files are as they were when they were read, without reading them again.
#pragma once

#include "base/files.h"

namespace strobe {

// Size, place on the disk and time of the last change of files and folders. A file that changed within the last few
// hundredths of a second may change again within the same tick of the clock: it does not count as current.
class Stamps {
 public:
  // As it is now; one that is missing counts too.
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
