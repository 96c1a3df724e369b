// SPDX-License-Identifier: MIT
// Per tile, the tile of origin of the longest displacement that passes over it. Second of three steps that scatter
// displacements along their paths, as Unity's HDRP does.
// In:  `longest`: longest displacement of each tile, px over the exposure.
//      `length`: largest length of the displacements that pass over each tile, px over the exposure, as the bits of a float
//        (tile/scatter_length.glsl).
// Out: `source`: code of the tile of origin: number of all tiles minus the index of the tile in raster order; 0 if no
//        displacement passes over the tile.
// Method: each tile repeats the walk of tile/scatter_length.glsl. Where `length` equals the length of its own displacement, the
//   tile writes its code by an atomic maximum. The maximum of the codes is the first tile in raster order.
// Fails: if equally long displacements cross at a tile, only the one of the first tile is kept.
#include "mixin/tile_walk.glsl"

void run(ivec2 tile) {
  ivec2 tiles = textureSize(longest_tex, 0);
  float d_length = lengthOf(vec2(texelFetch(longest_tex, tile, 0)));
  if (d_length == 0.0) return;
  uint own = uint(tiles.x * tiles.y - (tile.y * tiles.x + tile.x));
  Walk walk = walkOf(tile, tiles);
  for (int step = walk.first; step <= walk.last; ++step) {
    ivec2 at = placeOf(walk, step);
    if (isInside(at, tiles) && texelFetch(length_tex, at, 0).x == floatBitsToUint(d_length))
      imageAtomicMax(source_img, at, own);
  }
}
