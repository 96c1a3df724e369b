// SPDX-License-Identifier: MIT
// `strobe live`: a shot in a window that stays open while values and files change.
#pragma once

#include <optional>
#include <string>

#include "lab/tev.h"
#include "live/desk.h"

namespace strobe::live {

// Options of `strobe live`: start values of the work in the window, window size in pixels, drive file, tev viewer, time
// limit in seconds and validation layer.
struct LiveOptions {
  DeskOptions desk;
  int width = 1400, height = 900;      // size of the window, pixels
  bool size_given = false;             // the picture's size was given; otherwise software devices draw a small one
  std::string drive;                   // file of commands; "" without one
  std::optional<lab::TevAddress> tev;  // receives a copy of every picture
  double time_limit_s = 10;            // for one submission to the device; 0 for no limit
  bool validation = false;
};

// Returns when the window is closed. Throws `Error` without a display, if the shot cannot run at the start, if a
// command of the drive file fails, and at the end if the validation layer had messages.
void runLive(const Home& home, const LiveOptions& options);

}  // namespace strobe::live
