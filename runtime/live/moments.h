// SPDX-License-Identifier: MIT
// States of the window in a recording.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lab/shot.h"

namespace strobe::live {

// State of the window at one time: the shots of the displayed sides, each as `render` would draw it.
struct Moment {
  std::vector<lab::Shot> shots;
  std::vector<std::string> images;   // displayed images, one per shot; "color" by default
  size_t files = 0;                  // number of the version of scripts and shaders
  int first_frame = 0;               // first frame of the played sequence, which ends at the frame of the shots
  std::vector<std::string> changed;  // since the previous moment: parameters, options, "image", "files", "comparison"
  bool goes_on = false;              // a mouse button is down, or frames are being played
  bool saved = false;                // the picture was saved
};

// Moments in their order. Dragging a slider, flying the camera and stepping through images are one moment each, with
// the last value. Consecutive played frames are one moment, a sequence.
class Moments {
 public:
  void add(Moment now);  // computes `changed` and `first_frame`
  void markSaved();      // marks the last moment
  const std::vector<Moment>& all() const { return all_; }

 private:
  std::vector<Moment> all_;
};

// Settings of a shot. The last value of a name counts.
std::map<std::string, plan::Value> settingsOf(const lab::Shot& shot);

}  // namespace strobe::live
