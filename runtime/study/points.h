// SPDX-License-Identifier: MIT
// Points of an experiment: selection and list.
#pragma once

#include "study/experiment.h"

namespace strobe::study {

// Keeps the points that match `expression`: comma-separated conditions arm=NAME, shot=NAME, AXIS=VALUE, or AXIS alone
// (every point of that axis). Conditions with the same name are alternatives. If ratios are measured, the base point of
// the ratios stays too. Throws `Error` (exit code 2) for an unknown name, with the nearest name, and if no point is
// left.
void keepOnly(Experiment& experiment, const std::string& expression);

// One line per point: "1  vase  samples 4, exposure 0.5  blur".
std::string listOf(const Experiment& experiment);

// Values of a group: "samples 4, exposure 0.5"; "" without axes.
std::string describe(const Experiment& experiment, const Group& group);

}  // namespace strobe::study
