// SPDX-License-Identifier: MIT
// Draws the points of an experiment in several processes, each with a device of its own.
#pragma once

#include <functional>
#include <memory>

#include "study/run.h"

namespace strobe::study {

using MakeBench = std::function<std::unique_ptr<lab::Workbench>()>;

// Keeps in `store` what it does not have, but times; progress on stderr, with what `now` has of the results. This
// process must have no device, of which its copies could make no use; `started` is called in one of them. False: one of
// them failed and has said why; what it has not done is missing.
bool renderInProcesses(const Experiment& experiment, const MakeBench& bench, const Store& store, int jobs,
                       const Started& started, const std::function<Results()>& now);

}  // namespace strobe::study
