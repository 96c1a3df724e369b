// SPDX-License-Identifier: MIT
// Per cell, the least and greatest displacement and path deviation of its unreliable texels, component by component.
// In:  `velocity`: px over the exposure
//      `path_deviation`:     path deviation in the middle of the exposure, px
//      `valid`:    above 1/2 where the texel counts
// Out: `bounds`:   least x and y, greatest x and y of the displacements, px over the exposure; 0 if no texel counts
//      `deviation_bounds`:    least x and y, greatest x and y of the path deviations, px; 0 if no texel counts
// Method: minimum and maximum over the cell, whose side is `cell_side` px, after shortening to `limit` as filters do. Cells at
//      the right and bottom border may be partial.
// Fails: never; conservative. The box of two different motions also contains displacements that no texel has.
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
  vec4 bounds = kNoBounds, deviation_bounds = kNoBounds;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      ivec2 pixel = ivec2(x, y);
      if (!(texelFetch(valid_tex, pixel, 0).x > 0.5)) continue;
      bounds = with(bounds, texelFetch(velocity_tex, pixel, 0));
      deviation_bounds = with(deviation_bounds, texelFetch(path_deviation_tex, pixel, 0));
    }
  }
  imageStore(bounds_img, cell, isEmpty(bounds) ? vec4(0) : bounds);
  imageStore(deviation_bounds_img, cell, isEmpty(bounds) ? vec4(0) : deviation_bounds);
}
