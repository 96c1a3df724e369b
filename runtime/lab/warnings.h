// SPDX-License-Identifier: MIT
// Which limits a picture has met: those of its passes by their counts, those of the program (lab/limits.h) by its
// shot.
#pragma once

#include <string>
#include <vector>

#include "graph/graph.h"
#include "lab/shot.h"
#include "plan/plan.h"

namespace strobe::lab {

// "NODE: COUNT WHAT; what was done and what to do about it" for every count of a frame that is declared as a limit.
std::vector<std::string> limitsMet(const plan::Plan& plan, const graph::FrameResult& frame);

// Warnings about the colours of a frame, if its colour is read back.
std::vector<std::string> limitsMet(const graph::FrameResult& frame);

// Of the times a shot asks of its scene.
std::vector<std::string> limitsMet(const Shot& shot, const scene::Scene& scene);

}  // namespace strobe::lab
