// SPDX-License-Identifier: MIT
// Which facts of plan/facts.h hold in the frame of a shot.
#pragma once

#include "lab/shot.h"
#include "scene/facts.h"

namespace strobe::lab {

// When the frame of a shot poses the scene.
scene::FrameTimes frameTimesOf(const Shot& shot, const scene::Scene& scene);

// The time before the capture that the frame looks at too, seconds; of a pipeline that looks back at `earlier_frames`
// (plan::earlierFrames) the latest. The capture itself where the exposure has no length: displacements that are
// extrapolated are as long as it is.
double previousTime(const Shot& shot, int earlier_frames);

// Of a shot whose gaps are filled. Throws `Error` for an unknown camera or animation.
scene::Facts factsOf(const Shot& shot, const scene::Scene& scene, int earlier_frames);

// Those that do not hold, in the order of plan::facts(); none with --model-everything. For a pipeline that looks back
// at earlier frames paths are those since them; for one that draws parts of the exposure all facts of motion hold.
std::vector<std::string> absentFacts(const Shot& shot, const scene::Scene& scene,
                                     const plan::PipelineDesc& pipeline = {});

}  // namespace strobe::lab
