// SPDX-License-Identifier: MIT
// Per tile, how much the directions of motion around it differ (Guertin et al. 2014).
// In:  longest (px over the exposure, per tile), dominant (the same, of the tiles around).
// Out: variance, 1 - mean over the 3 x 3 tiles around of |u . u'|, u the unit direction of the tile's longest
//   displacement, u' of the other's. Tiles at rest (up to 1/2 px) do not count; a tile that is at rest itself takes the
//   direction of what reaches it. 0 where nothing moves.
// Fails: one displacement per tile; crossing motions in one tile go unnoticed.
#include "lib/blur.glsl"

bool moves(vec2 d) { return lengthOf(d) > 0.5; }

void run(ivec2 pixel) {
  ivec2 size = textureSize(longest_tex, 0);
  vec2 own = vec2(texelFetch(longest_tex, pixel, 0));
  if (!moves(own)) own = vec2(texelFetch(dominant_tex, pixel, 0));
  float aligned = 0.0, count = 0.0;
  for (int y = max(pixel.y - 1, 0); y <= min(pixel.y + 1, size.y - 1); ++y) {
    for (int x = max(pixel.x - 1, 0); x <= min(pixel.x + 1, size.x - 1); ++x) {
      vec2 d = vec2(texelFetch(longest_tex, ivec2(x, y), 0));
      if (!moves(d) || !moves(own)) continue;
      aligned += min(abs(dot(own / lengthOf(own), d / lengthOf(d))), 1.0);
      count += 1.0;
    }
  }
  imageStore(variance_img, pixel, vec4(count > 0.0 ? 1.0 - aligned / count : 0.0, 0, 0, 0));
}
