// SPDX-License-Identifier: MIT
// Copies of the home folder for test programs, and a watch on the files that the programs open.
#pragma once

#include <string>
#include <vector>

#include "base/files.h"

namespace strobe::mutate {

// Temporary copy of the passes, shaders and scripts of a home folder. The destructor removes the copy.
class HomeCopy {
 public:
  explicit HomeCopy(const Path& home);
  ~HomeCopy();
  HomeCopy(const HomeCopy&) = delete;
  HomeCopy& operator=(const HomeCopy&) = delete;
  const Path& folder() const { return folder_; }

 private:
  Path folder_;
};

// Watch on a folder (inotify): collects the names of opened files.
class OpenedFiles {
 public:
  explicit OpenedFiles(const Path& folder);
  ~OpenedFiles();
  OpenedFiles(const OpenedFiles&) = delete;
  OpenedFiles& operator=(const OpenedFiles&) = delete;
  // Adds the files opened since the last call, relative to the folder, sorted. False if events were lost.
  bool collect(std::vector<std::string>& files);

 private:
  int descriptor_ = -1;
  std::vector<std::pair<int, std::string>> folders_;  // watch descriptor, name like "lib/"
};

}  // namespace strobe::mutate
