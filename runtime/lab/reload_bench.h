// SPDX-License-Identifier: MIT
// Time from saving a file to the first picture made with it, by phase.
#pragma once

#include "lab/session.h"

namespace strobe::lab {

// Milliseconds, median over the repeats.
struct ReloadTiming {
  std::string edit;        // name of the edited kind of file
  double watch = 0;        // time until the change is noticed, and other waiting
  double evaluate = 0;     // Lua
  double compile = 0;      // GLSL to pipelines
  double build = 0;        // plan, images, descriptor sets
  double first_frame = 0;  // includes the compilation of new shaders on a software device
  double later_frame = 0;
  double added() const { return watch + evaluate + build; }  // without compilation and frames
};

// Edits each kind of file `repeats` times while a session of `shot` runs. The home of the bench must be a copy.
std::vector<ReloadTiming> benchReload(Workbench& bench, const Shot& shot, int repeats);

// Timings as a Markdown table.
std::string tableOf(const std::vector<ReloadTiming>& timings);

}  // namespace strobe::lab
