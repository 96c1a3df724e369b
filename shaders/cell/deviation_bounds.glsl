// SPDX-License-Identifier: MIT
// Per cell (a square of `cell_side` px), the bounds of displacements and of path deviations over its unreliable texels. The
// pass `classify_time_samples` derives from them where and when the layers are unreliable.
// In:  `velocity`: displacement of each texel, px over the exposure.
//      `path_deviation`: offset (x, y) of the surface from the straight line between the ends of its path, in the middle of the
//        exposure, px.
//      `valid`: mask, above 1/2 at unreliable texels.
// Out: `bounds`: least x and y, greatest x and y of the displacements, px over the exposure; 0 if no texel is unreliable.
//      `deviation_bounds`: least x and y, greatest x and y of the path deviations, px; 0 if no texel is unreliable.
// Method: minimum and maximum over the cell, component by component. Displacements and deviations are first shortened to
//   `limit`, as in filters. Cells at the right and bottom border may be partial.
// Fails: never too narrow. If a cell contains two different motions, its bounds also contain displacements that no texel has.
#include "lib/bounds.glsl"
#include "lib/sanitise.glsl"
#include "mixin/limit.glsl"

// Bounds enlarged to contain the vector of one more texel.
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
