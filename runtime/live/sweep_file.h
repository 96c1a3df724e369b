// SPDX-License-Identifier: MIT
// A sweep as an experiment for `strobe sweep` (docs/writing-experiments.md).
#pragma once

#include "live/sweep_axis.h"

namespace strobe::live {

// Content of a parameter sweep's experiment file: the shot, the swept values and the ground truth.
struct SavedSweep {
  lab::Shot shot;       // shot at any of the swept values
  lab::Shot suggested;  // options that the scene suggests; equal options are omitted
  std::vector<SweepAxis> axes;
  std::string truth;  // pipeline of the ground truth
  script::Settings truth_sets;
  bool regions = false;  // the ground truth separates pixels inside and outside of silhouettes
};

// Text of the experiment file.
std::string experimentText(const SavedSweep& sweep);

}  // namespace strobe::live
