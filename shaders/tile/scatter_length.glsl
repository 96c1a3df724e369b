// SPDX-License-Identifier: MIT
// Scatters the length of each tile's displacement to all tiles on its path, as Unity's HDRP does; first of three steps.
// In:  `longest`: longest displacement of each tile, px over the exposure
// Out: `length`:  per tile, the largest scattered length, px, as the bits of a float; 0: none
// Method: walk over the tiles on the path (mixin/tile_walk.glsl) and write the length with an atomic maximum. The bits of
//      floats of at least 0 have the order of the floats.
// Fails: only the path of the tile's centre is walked. One displacement represents the tile.
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
