// SPDX-License-Identifier: MIT
// Defaults of a scene: a camera, a light, and light intensities that suit a picture of exposure 1.
#pragma once

#include "math/bounds.h"
#include "scene/scene.h"

namespace strobe::scene {

// World bounds of all drawn objects, at rest.
Bounds boundsOf(const Scene& scene);

// Adds defaults, each with a line in `assumptions`:
// - Without a camera: a camera "default" with a vertical angle of 40 degrees. The camera covers the whole scene during
//   its animations, from the front, a little from the right and above.
// - Without a light, if a material needs light: a directional light without shadow, 1.6, 1.52, 1.4 lux. The light moves
//   with the camera `camera` ("" for the first), 20 degrees from its left and above. If the environment is also black:
//   a sky of .42 .45 .50 over a ground of .22 .20 .18.
// A complete scene is not changed.
void supplyDefaults(Scene& scene, const std::string& camera = "");

// Scales lights in physical units, which may have any magnitude. The illuminance in the middle of the bounds is
// estimated (candela over the squared distance, at least a tenth of the bounds' radius; lux unchanged). If the estimate
// is outside of 0.3 to 10 lux, one factor for all lights makes it pi: a white surface there is then as bright as the
// white of the display. The factor is noted in `assumptions`.
void moderateLights(Scene& scene);

}  // namespace strobe::scene
