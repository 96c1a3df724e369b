// SPDX-License-Identifier: MIT
// Per tile, the variance of the directions of motion in the 3x3 tiles around it (Guertin et al. 2014).
// In:  `longest`: longest displacement of each tile, px over the exposure.
//      `dominant`: longest displacement that reaches each tile, px over the exposure.
// Out: `variance`: from 0 (all displacements are parallel to the tile's own longest displacement) to 1 (all are
//        perpendicular to it); 0 without motion.
// Method: variance = 1 - mean of |u . v|. u is the unit direction of this tile's longest displacement, or of `dominant` if the
//   tile is static. v is the unit direction of the longest displacement of each of the 3x3 tiles. Static tiles (displacements
//   up to 1/2 px) are left out of the mean.
// Fails: each tile has one displacement, so that motions that cross within a tile are missed.
#include "lib/blur.glsl"

bool moves(vec2 d) { return lengthOf(d) > 0.5; }

void run(ivec2 tile) {
  ivec2 size = textureSize(longest_tex, 0);
  vec2 own = vec2(texelFetch(longest_tex, tile, 0));
  if (!moves(own)) own = vec2(texelFetch(dominant_tex, tile, 0));
  float aligned = 0.0, count = 0.0;
  for (int y = max(tile.y - 1, 0); y <= min(tile.y + 1, size.y - 1); ++y) {
    for (int x = max(tile.x - 1, 0); x <= min(tile.x + 1, size.x - 1); ++x) {
      vec2 d = vec2(texelFetch(longest_tex, ivec2(x, y), 0));
      if (!moves(d) || !moves(own)) continue;
      aligned += min(abs(dot(own / lengthOf(own), d / lengthOf(d))), 1.0);
      count += 1.0;
    }
  }
  imageStore(variance_img, tile, vec4(count > 0.0 ? 1.0 - aligned / count : 0.0, 0, 0, 0));
}
