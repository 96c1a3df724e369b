// SPDX-License-Identifier: MIT
// Per cell, between which displacements all of it lie.
// In:  velocity, after_velocity (px over the exposure; absent: velocity), valid (> 1/2: the texel counts);
//      curve (of their paths, px; absent: lines): counted as the straight displacements that hold a path.
// Out: bounds (least x and y, greatest x and y, px over the exposure, shortened to the limit as by filters).
//      A cell without texels that count holds kNoBounds. The last cells may be partial.
#include "lib/bounds.glsl"
#include "mixin/path.glsl"

vec4 with(vec4 bounds, vec4 texel) {
  vec2 d = clampLength(finiteDisplacement(texel), limitPx());
  return vec4(min(lowOf(bounds), d), max(highOf(bounds), d));
}

vec4 withCurve(vec4 bounds, ivec2 pixel) {
#if HAS_curve
  Path path = limitedPath(texelFetch(velocity_tex, pixel, 0), texelFetch(curve_tex, pixel, 0));
  vec2 around[4];
  straightened(path.d, path.curve, frame.shutter, around);
  for (int k = 0; k < 4; ++k) bounds = vec4(min(lowOf(bounds), around[k]), max(highOf(bounds), around[k]));
#endif
  return bounds;
}

bool counts(ivec2 pixel) {
#if HAS_valid
  return texelFetch(valid_tex, pixel, 0).x > 0.5;
#else
  return true;
#endif
}

void run(ivec2 cell) {
  ivec2 first = cell * params.cell_side;
  ivec2 end = min(first + params.cell_side, textureSize(velocity_tex, 0));
  vec4 bounds = kNoBounds;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      ivec2 pixel = ivec2(x, y);
      if (!counts(pixel)) continue;
      bounds = withCurve(with(bounds, texelFetch(velocity_tex, pixel, 0)), pixel);
#if HAS_after_velocity
      bounds = with(bounds, texelFetch(after_velocity_tex, pixel, 0));
#endif
    }
  }
  imageStore(bounds_img, cell, bounds);
}
