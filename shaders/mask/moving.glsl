// SPDX-License-Identifier: MIT
// All but what is still: every pixel that moves, by min_displacement or more, or to whose tile something that does can
// come within the exposure.
// In:  velocity (px over the exposure), dominant (the same, the longest that reaches each tile).
// Out: mask, 1 where something is to be revealed.
// Fails: marks whole tiles around everything that moves, most of which uncover nothing (cost, no error).
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

void run(ivec2 pixel) {
  vec2 own = finiteDisplacement(texelFetch(velocity_tex, pixel, 0));
  vec2 near = vec2(texelFetch(dominant_tex, pixel / params.tile, 0));
  float fastest = max(lengthOf(own), lengthOf(near));
  bool moves = fastest > 0.0 && fastest >= params.min_displacement;
  imageStore(mask_img, pixel, vec4(moves ? 1 : 0));
}
