// SPDX-License-Identifier: MIT
// `strobe live`: a shot in a window that stays while its values and files change.
#pragma once

#include <optional>
#include <string>

#include "lab/tev.h"
#include "live/desk.h"

namespace strobe::live {

struct LiveOptions {
  DeskOptions desk;
  int width = 1400, height = 900;      // of the window
  bool size_given = false;             // of the picture; else software devices get a small one
  std::string drive;                   // file of commands, or ""
  std::optional<lab::TevAddress> tev;  // every picture goes there as well
  double time_limit_s = 10;            // for what the device is given at once; 0: none
  bool validation = false;
};

// Returns when the window is closed. Throws `Error`: without a display, where the first version cannot run, where a
// command of the drive file fails, and with the messages of the validation layer at the end.
void runLive(const Home& home, const LiveOptions& options);

}  // namespace strobe::live
