// SPDX-License-Identifier: MIT
// The points of an experiment: which there are, and which of them a command asks for.
#pragma once

#include "study/experiment.h"

namespace strobe::study {

// Keeps the points that `expression` names: conditions with commas between, each arm=NAME, shot=NAME, AXIS=VALUE or
// AXIS alone (every point of that axis); several of one name allow each. Throws `Error` (exit code 2) for unknown
// names with the nearest, and where nothing is left. Where ratios are measured, the point that they are to stays.
void keepOnly(Experiment& experiment, const std::string& expression);

// "1  vase  samples 4, exposure 0.5  blur", a line each.
std::string listOf(const Experiment& experiment);

// "samples 4, exposure 0.5", or "" where nothing varies.
std::string describe(const Experiment& experiment, const Group& group);

}  // namespace strobe::study
