// SPDX-License-Identifier: MIT
// Draws and measures an experiment: every arm at every point, against truth there.
#pragma once

#include "lab/workbench.h"
#include "study/results.h"

namespace strobe::study {

// Progress on stderr. Where the layout shows pictures they and their records are written below `folder` as they come.
// Expectations are judged; the command is left to the caller. Numbers depend on the device, not on the run.
Results run(const Experiment& experiment, lab::Workbench& bench, const Path& folder);

}  // namespace strobe::study
