// SPDX-License-Identifier: MIT
// Per tile, the longest displacement scattered to it or to one of the 8 tiles around, as Unity's HDRP does; last of three
// steps.
// In:  `longest`:  longest displacement of each tile, px over the exposure
//      `source`:   per tile, code of the tile that scattered the longest displacement to it (tile/scatter_source.glsl)
// Out: `dominant`: longest scattered displacement, px over the exposure; among equal lengths, of the first tile in raster order
// Method: maximum over 3 x 3 tiles, because a tile is wider than the line along which its centre was scattered.
// Fails: one displacement represents all that arrive. It also dominates tiles that are one tile farther than it reaches.
#include "lib/blur.glsl"

void run(ivec2 pixel) {
  ivec2 tiles = textureSize(longest_tex, 0);
  vec2 dominant = vec2(0);
  float dominant_length = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      ivec2 at = pixel + ivec2(x, y);
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
  imageStore(dominant_img, pixel, vec4(dominant, 0, 0));
}
