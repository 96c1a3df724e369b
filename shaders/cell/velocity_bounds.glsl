// SPDX-License-Identifier: MIT
// Per cell, the least and greatest displacement, component by component.
// In:  `velocity`:       px over the exposure
//      `velocity_post`: px over the exposure, after the raster time; absent: `velocity`
//      `valid`:          above 1/2 where the texel counts; absent: all count
//      `curve`:          curves of the paths, px; absent: straight
// Out: `bounds`:         least x and y, greatest x and y, px over the exposure; kNoBounds (least above greatest) if no texel
//                        counts
// Method: minimum and maximum over the cell, whose side is `cell_side` px, after shortening to `limit` as filters do. A curved
//      path counts as the straight displacements to its control points, which contain it. Cells at the right and bottom border
//      may be partial.
// Fails: never; conservative. The box of two different motions also contains displacements that no texel has.
#include "lib/bounds.glsl"
#include "mixin/path.glsl"

vec4 with(vec4 bounds, vec4 texel) {
  vec2 d = clampLength(finiteDisplacement(texel), limitPx());
  return vec4(min(lowOf(bounds), d), max(highOf(bounds), d));
}

vec4 withCurve(vec4 bounds, ivec2 pixel) {
#if HAS_curve
  Path path = limitedPath(velocity_at(pixel), curve_at(pixel));
  vec2 around[4];
  straightened(path.d, path.curve, frame.shutter, around);
  for (int k = 0; k < 4; ++k) bounds = vec4(min(lowOf(bounds), around[k]), max(highOf(bounds), around[k]));
#endif
  return bounds;
}

void run(ivec2 cell) {
  ivec2 first = cell * params.cell_side;
  ivec2 end = min(first + params.cell_side, textureSize(velocity_tex, 0));
  vec4 bounds = kNoBounds;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      ivec2 pixel = ivec2(x, y);
      if (valid_at(pixel).x <= 0.5) continue;
      bounds = withCurve(with(bounds, velocity_at(pixel)), pixel);
      bounds = with(bounds, velocity_post_at(pixel));
    }
  }
  imageStore(bounds_img, cell, bounds);
}
