// SPDX-License-Identifier: MIT
// Per tile, the variance of the directions of motion around it (Guertin et al. 2014).
// In:  `longest`:  longest displacement of each tile, px over the exposure
//      `dominant`: longest displacement that reaches each tile, px over the exposure
// Out: `variance`: 0 (all displacements along one line) to 1 (all across it); 0 if the tiles are static
// Method: 1 - mean of |u . u'| over the 3 x 3 tiles around, u and u' the unit directions of this tile's and the other tile's
//      longest displacement. Static tiles (up to 1/2 px) do not count. If this tile is static, u is the direction of
//      `dominant`.
// Fails: one displacement per tile: motions that cross within a tile are not detected.
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
