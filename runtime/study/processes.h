// SPDX-License-Identifier: MIT
// Draws the points of an experiment in several processes, each with its own device.
#pragma once

#include <functional>
#include <memory>

#include "study/run.h"

namespace strobe::study {

using MakeBench = std::function<std::unique_ptr<lab::Workbench>()>;

// Draws the points that `store` lacks; does not measure times. Progress on stderr, with the front of `now()`. The
// calling process must not have a device, because forked copies cannot use it. `started` is called in one of the
// copies. Returns false if a copy failed; the copy has printed the reason, and its unfinished points are missing.
bool renderInProcesses(const Experiment& experiment, const MakeBench& bench, const Store& store, int jobs,
                       const Started& started, const std::function<Results()>& now);

}  // namespace strobe::study
