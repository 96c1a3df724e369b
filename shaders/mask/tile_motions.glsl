// SPDX-License-Identifier: MIT
// Per tile, two displacements that stand for all in it: the longest one, a, and the one that differs most from a. A
// tile with two movements yields both, whatever they are. And how far away the farthest is that moves.
// In:  velocity (px over the exposure), depth (view depth, sky +inf).
// Out: motions (xy a, zw the other; px over the exposure, within the limit), farthest (view depth; 0 where nothing moves).
// Ties go to the first in raster order. Fails: the third of three movements in a tile.
#include "mixin/limit.glsl"
#include "lib/sanitise.glsl"

vec2 displacementAt(ivec2 pixel) {
  return clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limitPx());
}

// Of the displacements in the tile, the one farthest from `from`.
vec2 farthestFrom(vec2 from, ivec2 first, ivec2 end) {
  vec2 farthest = displacementAt(first);
  float distance_px = lengthOf(farthest - from);
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      vec2 d = displacementAt(ivec2(x, y));
      float d_distance_px = lengthOf(d - from);
      if (d_distance_px <= distance_px) continue;
      farthest = d;
      distance_px = d_distance_px;
    }
  }
  return farthest;
}

float farthestMoving(ivec2 first, ivec2 end) {
  float farthest = 0.0;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      if (displacementAt(ivec2(x, y)) == vec2(0)) continue;
      farthest = max(farthest, saneDepth(texelFetch(depth_tex, ivec2(x, y), 0).x));
    }
  }
  return farthest;
}

void run(ivec2 pixel) {
  ivec2 first = pixel * params.tile;
  ivec2 end = min(first + params.tile, textureSize(velocity_tex, 0));
  vec2 longest = farthestFrom(vec2(0), first, end);
  vec2 other = farthestFrom(longest, first, end);
  imageStore(motions_img, pixel, vec4(longest, other));
  imageStore(farthest_img, pixel, vec4(longest == vec2(0) ? 0.0 : farthestMoving(first, end)));
}
