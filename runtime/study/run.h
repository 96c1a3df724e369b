// SPDX-License-Identifier: MIT
// Runs an experiment: draws and measures every point that its folder lacks.
#pragma once

#include "lab/workbench.h"
#include "study/tasks.h"

namespace strobe::study {

// Draws the points that `store` lacks, then measures times; reports progress on stderr. `store` gets the outline, and
// each point when it is drawn, with pictures and records if the layout shows these. A failed point has the reason.
// Evaluates the expectations; the caller sets `command`. Numbers depend on the device, not on the run.
Results run(const Experiment& experiment, lab::Batch& batch, const Store& store);

using MakeBench = std::function<std::unique_ptr<lab::Workbench>()>;

// Draws the points that `store` lacks; does not measure times. Progress on stderr. The calling process must not have a
// device, because forked copies cannot use it. Returns false if a copy failed; the copy has printed the reason, and its
// unfinished points are missing.
bool renderInProcesses(const Experiment& experiment, const MakeBench& bench, const Store& store, int jobs);

// Nodes of a shot's plan that the pipeline without blur (kind `Sharp`) also has, with the same name and pass: the
// raster passes. All other nodes are the method's own. Throws `Error` without such a pipeline.
std::set<std::string> capturedNodes(lab::Batch& batch, const lab::Shot& shot);

}  // namespace strobe::study
