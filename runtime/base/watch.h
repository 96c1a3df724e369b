// SPDX-License-Identifier: MIT
// Reports changes below folders. The caller finds the changed files.
#pragma once

#include <map>

#include "base/files.h"

namespace strobe {

// Reports files that were written and closed, renamed, linked, or removed, but not files that are still being written.
// Watches new folders too. If the system cannot watch, `changed` is true ten times a second.
class FileWatch {
 public:
  FileWatch();
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  // Watches `folder`, all folders below it, and the targets of links in them. Ignores a missing folder.
  void add(const Path& folder);
  // Watches `folder` only. The folders around a user's file may be a whole disk.
  void addFlat(const Path& folder);
  // Watches the folders of a link and of its targets, along a chain of links. Ignores files that are not links.
  void addBehind(const Path& link);
  // True if anything changed since the last call. Does not block.
  bool changed();

 private:
  struct Folder {
    Path path;
    bool deep = false;  // new folders and links in it are watched too
  };
  void addOne(const Folder& folder);

  int descriptor_ = -1;
  double look_again_s_ = 0;        // time of the next true result if the system cannot watch
  std::map<int, Folder> folders_;  // by watch descriptor
};

}  // namespace strobe
