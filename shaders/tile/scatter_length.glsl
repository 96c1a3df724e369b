// SPDX-License-Identifier: MIT
// Per tile, the length of the longest displacement that passes over it. First of three steps that scatter displacements
// along their paths, as Unity's HDRP does. Other filters gather them from surrounding tiles instead
// (tile/neighbour_max.glsl).
// In:  `longest`: longest displacement of each tile, px over the exposure.
// Out: `length`: largest length, px over the exposure, as the bits of a float; 0 if no displacement passes over the tile.
// Method: each tile walks over the tiles on its path within the exposure (mixin/tile_walk.glsl), and writes the length of its
//   longest displacement there by an atomic maximum. The maximum of the bits is the maximum of the lengths, because floats of
//   at least 0 have the order of their bits.
// Fails: the walk follows the path of the tile's centre, and one displacement represents the tile.
#include "mixin/tile_walk.glsl"

void run(ivec2 tile) {
  ivec2 tiles = textureSize(longest_tex, 0);
  float d_length = lengthOf(vec2(texelFetch(longest_tex, tile, 0)));
  if (d_length == 0.0) return;
  Walk walk = walkOf(tile, tiles);
  for (int step = walk.first; step <= walk.last; ++step) {
    ivec2 at = placeOf(walk, step);
    if (isInside(at, tiles)) imageAtomicMax(length_img, at, floatBitsToUint(d_length));
  }
}
