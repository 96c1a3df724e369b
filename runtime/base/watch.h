// SPDX-License-Identifier: MIT
// Reports that something below some folders changed; what it was is for the caller to find out.
#pragma once

#include <map>

#include "base/files.h"

namespace strobe {

// Sees files that were written and closed, renamed, made by renaming or linking, or removed; not those still being
// written. Folders that appear later are followed too. Where the system cannot watch, `changed` is true ten times a
// second.
class Watch {
 public:
  Watch();
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // Watches `folder`, all folders below it, and the targets of links in them. Ignores a missing folder.
  void add(const Path& folder);
  // `folder` alone: what lies around a user's own file may be a whole disk.
  void addFlat(const Path& folder);
  // Watches the folders of a link and of its targets, along a chain of links. Ignores files that are not links.
  void addBehind(const Path& link);
  // Whether anything happened since the last call. Does not block.
  bool changed();

 private:
  struct Folder {
    Path path;
    bool deep = false;  // what appears in it is watched as well
  };
  void addOne(const Folder& folder);

  int descriptor_ = -1;
  double look_again_s_ = 0;        // where there is none
  std::map<int, Folder> folders_;  // by watch descriptor
};

}  // namespace strobe
