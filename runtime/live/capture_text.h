// SPDX-License-Identifier: MIT
// Capture script of a recording.
#pragma once

#include "live/moments.h"

namespace strobe::live {

// Content of a capture script. `suggested`: shot options that the scene suggests, for each version of the files and
// scene (`sceneKey`). `folders`: folder of the differing files, for each version of the files; "" if no file differs.
struct Recorded {
  std::vector<Moment> moments;
  std::map<std::string, lab::Shot> suggested;
  std::vector<std::string> folders;
};
std::string sceneKey(size_t files, const lab::Shot& shot);
std::string captureText(const Recorded& recorded);

}  // namespace strobe::live
