// SPDX-License-Identifier: MIT
// Runs an experiment: draws and measures every point that its folder lacks.
#pragma once

#include "lab/workbench.h"
#include "study/tasks.h"

namespace strobe::study {

// Results before a picture is drawn: every point with its key, or the reason why the point cannot be drawn. With
// `takePoints`, the current results at any time.
Results outlineOf(const Experiment& experiment, const std::vector<TaskGroup>& groups, lab::Batch& batch);

// Called before the first picture is drawn.
using Started = std::function<void(const Results& outline)>;

// Draws the points that `store` lacks, then measures times; reports progress on stderr. `store` gets each point when it
// is drawn, with pictures and records if the layout shows these. A failed point has the reason. Evaluates the
// expectations; the caller sets `command`. Numbers depend on the device, not on the run.
Results run(const Experiment& experiment, lab::Batch& batch, const Store& store, const Started& started = {});
Results run(const Experiment& experiment, lab::Workbench& bench, const Store& store, const Started& started = {});

}  // namespace strobe::study
