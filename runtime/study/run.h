// SPDX-License-Identifier: MIT
// Runs an experiment: every arm at every point against truth there, as far as its folder does not have that yet.
#pragma once

#include "lab/workbench.h"
#include "study/tasks.h"

namespace strobe::study {

// Everything that is known before a picture is drawn: every point with its key, or why it cannot be drawn. With
// `takePoints` it is what there is of the results at any time.
Results outlineOf(const Experiment& experiment, const std::vector<TaskGroup>& groups, lab::Batch& batch);

// Called before the first picture is drawn.
using Started = std::function<void(const Results& outline)>;

// Progress on stderr. What is drawn is kept in `store` as it comes, with pictures and records where the layout shows
// them; what it has is not drawn again. Times are measured last. A point that fails keeps its reason. Expectations are
// judged; the command is left to the caller. Numbers depend on the device, not on the run.
Results run(const Experiment& experiment, lab::Batch& batch, const Store& store, const Started& started = {});
Results run(const Experiment& experiment, lab::Workbench& bench, const Store& store, const Started& started = {});

}  // namespace strobe::study
