// SPDX-License-Identifier: MIT
// A recording as a capture script.
#pragma once

#include "live/moments.h"

namespace strobe::live {

// The script's text. `suggested`: by version of the files and scene (`sceneKey`), the options that it suggests.
// `folders`: of each version of the files, the folder of those that differ, "" where none does.
struct Recorded {
  std::vector<Moment> moments;
  std::map<std::string, lab::Shot> suggested;
  std::vector<std::string> folders;
};
std::string sceneKey(size_t files, const lab::Shot& shot);
std::string captureText(const Recorded& recorded);

}  // namespace strobe::live
