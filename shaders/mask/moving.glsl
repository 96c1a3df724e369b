// SPDX-License-Identifier: MIT
// Mask of the pixels that move, or that a moving surface may reach within the exposure.
// In:  `velocity`: displacement of the surface at each pixel, px over the exposure.
//      `dominant`: longest displacement that reaches each tile, px over the exposure.
// Out: `mask`: 1 where the pass `ray_reveal` traces a ray to the background, otherwise 0.
// Method: the mask is 1 if the longer of the two displacements is not 0 and at least `min_displacement` px long.
// Fails: marks whole tiles around moving surfaces, although most of their pixels disocclude nothing. This costs rays, but
//   causes no error.
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

void run(ivec2 pixel) {
  vec2 own = finiteDisplacement(texelFetch(velocity_tex, pixel, 0));
  vec2 near = vec2(texelFetch(dominant_tex, pixel / params.tile, 0));
  float fastest = max(lengthOf(own), lengthOf(near));
  bool moves = fastest > 0.0 && fastest >= params.min_displacement;
  imageStore(mask_img, pixel, vec4(moves ? 1 : 0));
}
