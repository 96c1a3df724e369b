// SPDX-License-Identifier: MIT
// Limits that a picture met: limits of its passes by counters, limits of the program (lab/limits.h) by its shot and
// colours.
#pragma once

#include <string>
#include <vector>

#include "base/limit.h"
#include "graph/graph.h"
#include "lab/shot.h"
#include "plan/plan.h"

namespace strobe::lab {

// Facts "NODE: COUNT WHAT", one for each nonzero counter that is declared as a limit.
std::vector<LimitMet> limitsMet(const plan::Plan& plan, const graph::FrameResult& frame);

// Limit of non-finite colours of a frame, if its colour is read back.
std::vector<LimitMet> limitsMet(const graph::FrameResult& frame);

// Limits of the exposure of a shot and the clips of its scene.
std::vector<LimitMet> limitsMet(const Shot& shot, const scene::Scene& scene);

}  // namespace strobe::lab
