// SPDX-License-Identifier: MIT
// Each tile whose displacement is the longest that came to a tile on its way (mixin/tile_walk.glsl) leaves its number there.
// In:  longest (px over the exposure, per tile), length (per tile the largest that came there, bits of a float).
// Out: source, per tile the number of tiles less that, in raster order, of the one that the longest is from; of equally long
//   ones the first. 0: none came.
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
