// SPDX-License-Identifier: MIT
// Renders an experiment of extremes: every method at every value of every axis, against truth there.
#pragma once

#include "lab/workbench.h"
#include "stability/curves_experiment.h"
#include "stability/curves_report.h"

namespace strobe::stability::curves {

// Progress on stderr. The report's command is left to the caller. Numbers depend on the device, not on the run.
Report measure(const Experiment& experiment, lab::Workbench& bench);

}  // namespace strobe::stability::curves
