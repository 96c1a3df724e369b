// SPDX-License-Identifier: MIT
// Clips of a scene: jumps at their ends, and the clips that play together.
#pragma once

#include "scene/scene.h"

namespace strobe::scene {

// True if the value of a track at the end of its clip differs from its value at the start by more than the rounding of
// floats. False for STEP tracks, because they do not blur. The quaternions q and -q are one rotation.
bool jumpsAtTheEnd(const Animation& clip, const Track& track);

// Sets `yields_to` and `shared_target` of clips that drive a target of an earlier clip that plays.
void yieldClips(Scene& scene);

// Number of frames until playback repeats: the loop suggested by the scene, else the longest clip, else two seconds.
int loopFrames(const Scene& scene, double fps);

}  // namespace strobe::scene
