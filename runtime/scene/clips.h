// SPDX-License-Identifier: MIT
// Clips of a scene: their tracks, and which clips play together.
#pragma once

#include "scene/scene.h"

namespace strobe::scene {

// The keys of all tracks of a clip: of nodes, of weights, of cameras and lights.
std::vector<const Track*> tracksOf(const Animation& clip);

// True if a track has another value at the end of its clip than where the clip begins again, by more than the rounding
// of floats. STEP tracks do not blur, so they never jump. The quaternions q and -q are one rotation.
bool jumpsAtTheEnd(const Animation& clip, const Track& track);

// Sets `yields_to` and `shared_target` of clips that drive a target of an earlier clip that plays.
void yieldClips(Scene& scene);

// Frames after which play begins anew: of the loop that the scene suggests, else of its longest clip, else of two
// seconds.
int loopFrames(const Scene& scene, double fps);

}  // namespace strobe::scene
