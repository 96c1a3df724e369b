// SPDX-License-Identifier: MIT
// What a scene lacks: a camera, light, light of a strength that a picture of exposure 1 can show.
#pragma once

#include "math/bounds.h"
#include "scene/scene.h"

namespace strobe::scene {

// World bounds of everything drawn, at rest.
Bounds boundsOf(const Scene& scene);

// Adds, each with a line in `assumptions`:
// - no camera: a camera "default" that looks at all of the scene, wherever its animations take it, from the front, a
//   little from the right and above, with a vertical angle of 40 degrees;
// - no light, and something that needs it: a directional light without shadow that moves with the camera `camera` (""
//   for the first), 20 degrees from its left and above, of 1.6, 1.52, 1.4 lux; and where the environment is black too,
//   a sky of .42 .45 .50 over a ground of .22 .20 .18.
// A scene that has all of it is left as it is.
void supplyDefaults(Scene& scene, const std::string& camera = "");

// For lights in physical units, which may be of any size: estimates what they send to the middle of the bounds
// (candela over the squared distance, at least a tenth of the bounds' radius; lux as it is). Outside of 0.3 to 10 lux,
// all lights are multiplied by one factor that makes it pi: a white surface there is then as bright as the display's
// white. The factor is noted in `assumptions`.
void moderateLights(Scene& scene);

}  // namespace strobe::scene
