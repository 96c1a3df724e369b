// SPDX-License-Identifier: MIT
// Per tile, the longest displacement that came to it or to one of the 8 around it: a tile is wider than the line of its centre.
// In:  longest (px over the exposure, per tile), source (of tile/scatter_source.glsl).
// Out: dominant (px over the exposure); of equally long ones that of the first tile in raster order around.
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
