// SPDX-License-Identifier: MIT
// Per tile, the tile that the longest scattered displacement comes from, as Unity's HDRP does; second of three steps.
// In:  `longest`: longest displacement of each tile, px over the exposure
//      `length`:  per tile, the largest scattered length, px, as the bits of a float (tile/scatter_length.glsl)
// Out: `source`:  code of the source tile: number of all tiles minus the source's index in raster order; 0: none
// Method: walk as in tile/scatter_length.glsl. Where the recorded length of a tile on the path equals the walking tile's
//      length, write the walking tile's code. The atomic maximum keeps the first tile in raster order.
// Fails: if equally long displacements cross at a tile, one source represents them all.
#include "mixin/tile_walk.glsl"

void run(ivec2 pixel) {
  ivec2 tiles = textureSize(longest_tex, 0);
  float d_length = lengthOf(vec2(texelFetch(longest_tex, pixel, 0)));
  if (d_length == 0.0) return;
  uint own = uint(tiles.x * tiles.y - (pixel.y * tiles.x + pixel.x));
  Walk walk = walkOf(pixel, tiles);
  for (int step = walk.first; step <= walk.last; ++step) {
    ivec2 at = placeOf(walk, step);
    if (isInside(at, tiles) && texelFetch(length_tex, at, 0).x == floatBitsToUint(d_length))
      imageAtomicMax(source_img, at, own);
  }
}
