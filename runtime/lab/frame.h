// SPDX-License-Identifier: MIT
// Frame of a shot: its times, poses, motion on the screen and facts.
#pragma once

#include "graph/frame.h"
#include "lab/shot.h"

namespace strobe::lab {

// Frame of a shot without unset options. The scene must outlive the result. Paths begin `earlier_frames` frames before
// the frame (plan::earlierFrames). Throws `Error` for an unknown camera or animation.
graph::Frame frameOf(const Shot& shot, const scene::Scene& scene, int earlier_frames = 0);

// Facts (plan/facts.h) that do not hold in a frame, in the order of plan::facts(); empty with --model-everything. For a
// pipeline that draws parts of the exposure, all facts about motion hold.
std::vector<std::string> absentFacts(const graph::Frame& frame, const plan::PipelineDesc& pipeline = {});

}  // namespace strobe::lab
