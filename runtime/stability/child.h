// SPDX-License-Identifier: MIT
// Runs another program until it ends or its time is over; copies of the home folder for it to read.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/files.h"

namespace strobe::stability {

struct ChildEnd {
  std::string output;  // of both streams
  int exit_code = -1;  // 128 + signal
  bool timed_out = false;
  double seconds = 0;
};

// `arguments[0]` is the program's path. `environment` ("NAME=value") comes before what this process has. At the limit
// the child's whole process group is killed; it also ends with this process. `meanwhile` is called now and then.
ChildEnd runProgram(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                    double limit_s, const std::function<void()>& meanwhile = {});

// Passes, shaders and scripts of a home folder in a folder of their own, gone with the object.
class HomeCopy {
 public:
  explicit HomeCopy(const Path& home = homeFolder());
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

}  // namespace strobe::stability
