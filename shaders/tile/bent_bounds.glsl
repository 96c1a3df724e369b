// SPDX-License-Identifier: MIT
// Per cell, between which displacements, and between which bends, all of what counts in it lies.
// In:  velocity (px over the exposure), bend (px in the middle of the exposure), valid (> 1/2: the texel counts).
// Out: bounds, bends (least x and y, greatest x and y, shortened to the limit as by filters). A cell without
//      texels that count holds 0: what does not move. The last cells may be partial.
#include "lib/bounds.glsl"
#include "lib/sanitise.glsl"
#include "mixin/limit.glsl"

vec4 with(vec4 bounds, vec4 texel) {
  vec2 d = clampLength(finiteDisplacement(texel), limitPx());
  return vec4(min(lowOf(bounds), d), max(highOf(bounds), d));
}

void run(ivec2 cell) {
  ivec2 first = cell * params.cell_side;
  ivec2 end = min(first + params.cell_side, textureSize(velocity_tex, 0));
  vec4 bounds = kNoBounds, bends = kNoBounds;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      ivec2 pixel = ivec2(x, y);
      if (!(texelFetch(valid_tex, pixel, 0).x > 0.5)) continue;
      bounds = with(bounds, texelFetch(velocity_tex, pixel, 0));
      bends = with(bends, texelFetch(bend_tex, pixel, 0));
    }
  }
  imageStore(bounds_img, cell, isEmpty(bounds) ? vec4(0) : bounds);
  imageStore(bends_img, cell, isEmpty(bounds) ? vec4(0) : bends);
}
