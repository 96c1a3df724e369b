// SPDX-License-Identifier: MIT
// Reduces each tile to two displacements that represent its motions, and to the depth of its farthest moving surface.
// In:  `velocity`: displacement of each pixel, px over the exposure
//      `depth`: view depth, metres; +inf for the sky
// Out: `velocities`: xy: longest displacement a; zw: displacement that differs most from a; px over the exposure. Displacements
//        are shortened to the parameter `limit`
//      `farthest`: view depth of the farthest moving surface, metres; 0 without motion
//      `max_displacement`: entry 0: longest displacement in the image, px over the exposure, as the bits of a float
// Method: one work group per tile finds three maxima, one after the other: of |d|, where d is the displacement of a texel; of
//   |d - a|; and of the depth of texels with d other than 0. Among equal values, the first texel in raster order counts. A tile
//   with two motions yields both motions.
// Fails: if a tile has three different motions, the third one is lost.
#include "mixin/limit.glsl"
#include "lib/group.glsl"
#include "lib/sanitise.glsl"

vec2 displacementAt(ivec2 pixel) {
  return clampLength(finiteDisplacement(texelFetch(velocity_tex, pixel, 0)), limitPx());
}

shared vec2 found;          // result of farthestFrom, written by one invocation for all
shared uint farthest_bits;  // largest depth, as the bits of a float: floats of at least 0 have the order of their bits

// Displacement in the tile that differs most from `from`, px over the exposure. The tile's texels are in [first, end). Contains
// barriers.
vec2 farthestFrom(vec2 from, ivec2 first, ivec2 end) {
  vec2 farthest = displacementAt(first);
  float distance_px = lengthOf(farthest - from);
  uint at = gl_LocalInvocationIndex == 0u ? 0u : ~0u;  // invocation 0 begins with the first texel
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

// View depth of the farthest moving surface in the tile, metres; 0 without motion. Contains a barrier.
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
