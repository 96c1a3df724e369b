// SPDX-License-Identifier: MIT
// Per tile, the longest displacement that passes over the tile or one of its 8 neighbours. Last of three steps that scatter
// displacements along their paths, as Unity's HDRP does.
// In:  `longest`: longest displacement of each tile, px over the exposure.
//      `source`: code of the tile of origin of the longest displacement that passes over each tile (tile/scatter_source.glsl).
// Out: `dominant`: longest displacement, px over the exposure; among equally long ones, the first in raster order of the 3x3
//        tiles.
// Method: maximum over 3x3 tiles, because a moving tile is wider than the line that its centre follows.
// Fails: one displacement represents all displacements that reach a tile. A displacement also dominates the tiles
//   beside its path and one tile beyond the end of its path, even if its surface does not reach them.
#include "lib/blur.glsl"

void run(ivec2 tile) {
  ivec2 tiles = textureSize(longest_tex, 0);
  vec2 dominant = vec2(0);
  float dominant_length = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      ivec2 at = tile + ivec2(x, y);
      uint source = isInside(at, tiles) ? texelFetch(source_tex, at, 0).x : 0u;
      if (source == 0u) continue;
      int number = tiles.x * tiles.y - int(source);
      ivec2 from = ivec2(number % tiles.x, number / tiles.x);
      vec2 d = vec2(texelFetch(longest_tex, from, 0));
      float d_length = lengthOf(d);
      if (d_length <= dominant_length) continue;
      dominant = d;
      dominant_length = d_length;
    }
  }
  imageStore(dominant_img, tile, vec4(dominant, 0, 0));
}
