// SPDX-License-Identifier: MIT
// Runs an experiment: draws and measures every point that its folder lacks.
#pragma once

#include <sys/types.h>

#include "lab/workbench.h"
#include "study/tasks.h"

namespace strobe::study {

// Draws the points of the experiment's share that `store` lacks, then measures times; reports progress on stderr.
// `store` gets the outline, and each point when it is drawn, with pictures and records if the layout shows these. A
// failed point has the reason. Waits for points that other programs draw. Calls `on_drawn` before times are measured.
// Evaluates the expectations of a whole experiment; the results of a share have the share's points only. The caller
// sets `command`. Numbers depend on the device, not on the run. Throws `Stopped`.
Results run(const Experiment& experiment, lab::Batch& batch, const Store& store,
            const std::function<void()>& on_drawn = {});

using MakeBench = std::function<std::unique_ptr<lab::Workbench>()>;

// Further processes that draw points which `store` lacks; they do not measure times. The constructor must run before
// this process has a device, because forked copies cannot use it.
class Helpers {
 public:
  Helpers(const Experiment& experiment, const MakeBench& make, const Store& store, int count);
  Helpers(const Helpers&) = delete;
  ~Helpers();  // stops the processes

  // Waits for their ends. Returns false if a process failed; it has printed the reason.
  bool wait();

 private:
  std::vector<pid_t> processes_;
};

// Nodes of a shot's plan that the pipeline without blur (kind `Sharp`) also has, with the same name and pass: the
// raster passes. All other nodes are the method's own. Throws `Error` without such a pipeline.
std::set<std::string> capturedNodes(lab::Batch& batch, const lab::Shot& shot);

}  // namespace strobe::study
