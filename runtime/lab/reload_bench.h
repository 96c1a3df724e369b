// SPDX-License-Identifier: MIT
// How long it takes from saving a file to the first picture made of it, and where the time goes.
#pragma once

#include "lab/session.h"

namespace strobe::lab {

// Milliseconds, medians over the repeats.
struct ReloadTiming {
  std::string edit;        // what was edited
  double watch = 0;        // from the end of the save until the change is being worked on, and waiting in between
  double evaluate = 0;     // Lua
  double compile = 0;      // GLSL to pipelines
  double build = 0;        // plan, images, descriptor sets
  double first_frame = 0;  // in which a software device compiles what is new
  double later_frame = 0;
  double added() const { return watch + evaluate + build; }  // beyond compilation and the frame
};

// Edits files of the bench's home, a copy, `repeats` times per kind of file while a session of `shot` runs on it.
std::vector<ReloadTiming> benchReload(Workbench& bench, const Shot& shot, int repeats);

// A Markdown table.
std::string tableOf(const std::vector<ReloadTiming>& timings);

}  // namespace strobe::lab
