// SPDX-License-Identifier: MIT
// Limits that a picture met: limits of its passes by counters, limits of the program (lab/limits.h) by its shot and
// colours.
#pragma once

#include <string>
#include <vector>

#include "graph/graph.h"
#include "lab/shot.h"
#include "plan/plan.h"

namespace strobe::lab {

// Warnings "NODE: COUNT WHAT; RESULT", one for each nonzero counter that is declared as a limit. RESULT: the
// consequence and a remedy.
std::vector<std::string> limitsMet(const plan::Plan& plan, const graph::FrameResult& frame);

// Warnings about non-finite colours of a frame, if its colour is read back.
std::vector<std::string> limitsMet(const graph::FrameResult& frame);

// Warnings about the exposure of a shot and the clips of its scene.
std::vector<std::string> limitsMet(const Shot& shot, const scene::Scene& scene);

}  // namespace strobe::lab
