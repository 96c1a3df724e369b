// SPDX-License-Identifier: MIT
// Copies of the home folder for another program to read, and which files it opened there.
#pragma once

#include <string>
#include <vector>

#include "base/files.h"

namespace strobe::mutate {

// Passes, shaders and scripts of a home folder in a folder of their own, gone with the object.
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

// Which files below a folder were opened since the last call.
class OpenedFiles {
 public:
  explicit OpenedFiles(const Path& folder);
  ~OpenedFiles();
  OpenedFiles(const OpenedFiles&) = delete;
  OpenedFiles& operator=(const OpenedFiles&) = delete;
  // Adds their names, relative to the folder. False where some were missed.
  bool collect(std::vector<std::string>& files);

 private:
  int descriptor_ = -1;
  std::vector<std::pair<int, std::string>> folders_;  // by watch descriptor: "lib/"
};

}  // namespace strobe::mutate
