// SPDX-License-Identifier: MIT
// Tells that something below some folders changed; what it was is for the caller to find out.
#pragma once

#include <map>

#include "base/files.h"

namespace strobe {

// Sees files that were written and closed, renamed, made by renaming or removed; not those still being written. Folders
// that appear later are followed too. Where the system cannot watch, `changed` is always true.
class Watch {
 public:
  Watch();
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // `folder` and all below it; nothing happens for one that is watched already or does not exist.
  void add(const Path& folder);
  // Whether anything happened since the last call. Does not block.
  bool changed();

 private:
  void addOne(const Path& folder);

  int descriptor_ = -1;
  std::map<int, Path> folders_;  // by watch descriptor
};

}  // namespace strobe
