// SPDX-License-Identifier: MIT
// Each tile tells all along its way (mixin/tile_walk.glsl) how long its displacement is.
// In:  longest (px over the exposure, per tile).
// Out: length, per tile the largest that came there, px, by the bits of a float: those of floats that are not negative are
//   ordered as their values.
#include "mixin/tile_walk.glsl"

void run(ivec2 pixel) {
  ivec2 tiles = textureSize(longest_tex, 0);
  float d_length = lengthOf(vec2(texelFetch(longest_tex, pixel, 0)));
  if (d_length == 0.0) return;
  Walk walk = walkOf(pixel, tiles);
  for (int step = walk.first; step <= walk.last; ++step) {
    ivec2 at = placeOf(walk, step);
    if (isInside(at, tiles)) imageAtomicMax(length_img, at, floatBitsToUint(d_length));
  }
}
