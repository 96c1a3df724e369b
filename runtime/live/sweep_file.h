// SPDX-License-Identifier: MIT
// A sweep as an experiment for `strobe sweep` (docs/writing-experiments.md).
#pragma once

#include "live/sweep_axis.h"

namespace strobe::live {

struct SavedSweep {
  lab::Shot shot;       // at any of the values
  lab::Shot suggested;  // what its scene says by itself: options that are alike are left out
  std::vector<SweepAxis> axes;
  std::string truth;  // a pipeline
  script::Settings truth_sets;
  bool regions = false;  // truth says which pixels lie inside and outside of silhouettes
};

// The file's text.
std::string experimentText(const SavedSweep& sweep);

}  // namespace strobe::live
