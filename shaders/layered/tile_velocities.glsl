// SPDX-License-Identifier: MIT
// Per tile, the two displacements that represent it, and the depth of its farthest moving surface.
// In:  velocity: displacement, px over the exposure.
//      depth: view depth, metres; +inf for the sky.
// Out: velocities: xy the longest displacement a, zw the displacement that differs most from a; px over the exposure, limited.
//      farthest: view depth of the farthest moving surface, metres; 0 without motion.
// Method: one work group per tile finds the maximum of |d|, then of |d - a|, then of the depth where d is not 0. At ties the
//   first texel in raster order counts. A tile with two motions yields both.
// Fails: the third of three motions in a tile.
#include "mixin/limit.glsl"
#include "lib/group.glsl"
#include "lib/sanitise.glsl"

vec2 displacementAt(ivec2 pixel) {
  return clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limitPx());
}

shared vec2 found;          // written by one invocation
shared uint farthest_bits;  // bits of a depth, which is not negative, so its bits have its order

// Displacement of the tile that differs most from `from`.
vec2 farthestFrom(vec2 from, ivec2 first, ivec2 end) {
  vec2 farthest = displacementAt(first);
  float distance_px = lengthOf(farthest - from);
  uint at = gl_LocalInvocationIndex == 0u ? 0u : ~0u;  // invocation 0 owns the first texel
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
  atomicMax(max_displacement_buf.entries[0], floatBitsToUint(lengthOf(longest)));
  imageStore(velocities_img, tile, vec4(longest, other));
  imageStore(farthest_img, tile, vec4(farthest));
}
