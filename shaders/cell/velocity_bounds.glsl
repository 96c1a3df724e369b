// SPDX-License-Identifier: MIT
// Per cell (a square of `cell_side` px), the least and the greatest displacement, component by component. Later passes skip a
// cell if these bounds prove that the cell needs no work.
// In:  `velocity`: displacement of each texel, px over the exposure; with two segments, velocity before the raster time.
//      `velocity_post`: velocity after the raster time, px over the exposure (absent: `velocity`).
//      `valid`: mask, above 1/2 at texels to include (absent: all texels).
//      `curve`: coefficients of the parabola or arc that each texel's path follows (mixin/curve.glsl; absent: paths are
//        straight).
// Out: `bounds`: least x and y, greatest x and y, px over the exposure; kNoBounds (least above greatest) if no texel is
//        included.
// Method: minimum and maximum over the cell. Displacements are first shortened to `limit`, as in filters. A curved path counts
//   as the straight displacements to its control points, because the box of the control points contains the path. Cells at the
//   right and bottom border may be partial.
// Fails: never too narrow. If a cell contains two different motions, its bounds also contain displacements that no texel has.
#include "lib/bounds.glsl"
#include "mixin/path.glsl"

// Bounds enlarged to contain the displacement of one more texel.
vec4 with(vec4 bounds, vec4 texel) {
  vec2 d = clampLength(finiteDisplacement(texel), limitPx());
  return vec4(min(lowOf(bounds), d), max(highOf(bounds), d));
}

// Bounds enlarged to contain the curved path of one more texel; unchanged if paths are straight.
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
