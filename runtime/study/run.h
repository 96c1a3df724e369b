// SPDX-License-Identifier: MIT
// Runs an experiment: every arm at every point against truth there, as far as its folder does not have that yet.
#pragma once

#include "lab/workbench.h"
#include "study/store.h"

namespace strobe::study {

// Progress on stderr. What is drawn is kept in `store` as it comes, with pictures and records where the layout shows
// them; what it has is not drawn again. Times are measured last. A point that fails keeps its reason. Expectations are
// judged; the command is left to the caller. Numbers depend on the device, not on the run.
Results run(const Experiment& experiment, lab::Workbench& bench, const Store& store);

}  // namespace strobe::study
