// SPDX-License-Identifier: MIT
// States of the window that a recording keeps.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lab/shot.h"

namespace strobe::live {

// What the window showed at a time: A, and B where it is compared, each as `render` would make it.
struct Moment {
  std::vector<lab::Shot> shots;
  std::vector<std::string> images;   // that were looked at, one per shot; "color" where there is none
  size_t files = 0;                  // which version of scripts and shaders
  int first_frame = 0;               // played from here to the frame of the shots
  std::vector<std::string> changed;  // against the one before: parameters, options, "image", "files", "comparison"
  bool goes_on = false;              // a button is down, or it plays
  bool saved = false;                // as a picture
};

// Moments in their order. A slider that is dragged, a camera that flies and images that are looked through are one
// moment each, with the last value; frames played one after another are one, a sequence.
class Moments {
 public:
  void add(Moment now);  // `changed` and `first_frame` are found here
  void markSaved();      // the last one
  const std::vector<Moment>& all() const { return all_; }

 private:
  std::vector<Moment> all_;
};

// The last value of each name.
std::map<std::string, plan::Value> settingsOf(const lab::Shot& shot);

}  // namespace strobe::live
