// SPDX-License-Identifier: MIT
// Facts (plan/facts.h) that hold in the frame of a shot.
#pragma once

#include "lab/shot.h"
#include "scene/facts.h"

namespace strobe::lab {

// Times of the poses of the frame of a shot.
scene::FrameTimes frameTimesOf(const Shot& shot, const scene::Scene& scene);

// Previous time that the frame uses, seconds: one frame interval before the raster time. For a pipeline with several
// `earlier_frames` (plan::earlierFrames) it is the latest of these frames. Equals the raster time if the exposure has
// no length and the pipeline uses no earlier frames, because extrapolated displacements then have no length.
double previousTime(const Shot& shot, int earlier_frames);

// Facts of the frame of a shot without unset options. Throws `Error` for an unknown camera or animation.
scene::Facts factsOf(const Shot& shot, const scene::Scene& scene, int earlier_frames);

// Facts that do not hold, in the order of plan::facts(); empty with --model-everything. For a pipeline that uses
// earlier frames, paths include these frames. For a pipeline that draws parts of the exposure, all facts about motion
// hold.
std::vector<std::string> absentFacts(const Shot& shot, const scene::Scene& scene,
                                     const plan::PipelineDesc& pipeline = {});

}  // namespace strobe::lab
