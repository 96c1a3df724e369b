// SPDX-License-Identifier: MIT
// Per tile, two displacements that stand for all in it: the longest one, a, and the one that differs most from a. A
// tile with two movements yields both, whatever they are. And how far away the farthest is that moves.
// In:  velocity (px over the exposure), depth (view depth, sky +inf).
// Out: motions (xy a, zw the other; px over the exposure, within the limit), farthest (view depth; 0 where nothing moves).
// Ties go to the first in raster order. Fails: the third of three movements in a tile.
#include "mixin/limit.glsl"
#include "lib/group.glsl"
#include "lib/sanitise.glsl"

vec2 displacementAt(ivec2 pixel) {
  return clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limitPx());
}

shared vec2 found;          // by one invocation
shared uint farthest_bits;  // of a depth, which is at least 0

// Of the displacements in the tile, the one farthest from `from`.
vec2 farthestFrom(vec2 from, ivec2 first, ivec2 end) {
  vec2 farthest = displacementAt(first);
  float distance_px = lengthOf(farthest - from);
  uint at = gl_LocalInvocationIndex == 0u ? 0u : ~0u;  // the first texel is that invocation's
  ivec2 own = ownFirst(first);
  for (int y = own.y; y < end.y; y += kGroupSide) {
    for (int x = own.x; x < end.x; x += kGroupSide) {
      vec2 d = displacementAt(ivec2(x, y));
      float d_distance_px = lengthOf(d - from);
      if (d_distance_px <= distance_px) continue;
      farthest = d;
      distance_px = d_distance_px;
      at = placeInTile(ivec2(x, y), first, params.tile);
    }
  }
  if (isGreatest(distance_px, at)) found = farthest;
  barrier();
  return found;
}

float farthestMoving(ivec2 first, ivec2 end) {
  float farthest = 0.0;
  ivec2 own = ownFirst(first);
  for (int y = own.y; y < end.y; y += kGroupSide) {
    for (int x = own.x; x < end.x; x += kGroupSide) {
      if (displacementAt(ivec2(x, y)) == vec2(0)) continue;
      farthest = max(farthest, saneDepth(texelFetch(depth_tex, ivec2(x, y), 0).x));
    }
  }
  atomicMax(farthest_bits, floatBitsToUint(farthest));
  barrier();
  return uintBitsToFloat(farthest_bits);
}

void run(ivec2 tile) {
  if (gl_LocalInvocationIndex == 0u) farthest_bits = 0u;
  ivec2 first = tile * params.tile;
  ivec2 end = min(first + params.tile, textureSize(velocity_tex, 0));
  vec2 longest = farthestFrom(vec2(0), first, end);
  vec2 other = farthestFrom(longest, first, end);
  float farthest = longest == vec2(0) ? 0.0 : farthestMoving(first, end);
  if (gl_LocalInvocationIndex != 0u) return;
  imageStore(motions_img, tile, vec4(longest, other));
  imageStore(farthest_img, tile, vec4(farthest));
}
