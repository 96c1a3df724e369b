// SPDX-License-Identifier: MIT
// Length of the longest displacement in the image.
// In:  `longest`: longest displacement of each tile, px over the exposure
//      `after`, `revealed`, `revealed_after`: longest displacements after the raster time, and of the revealed layer; absent:
//                 none
//      `curve`:   curves of the paths of `longest`, px; absent: straight
// Out: `reach`:   px over the exposure, one texel
// Method: maximum over all tiles. A curved path counts as the straight displacement that reaches as far.
// Fails: never. One invocation reads all tiles, which is slow for a large image with tiles of one or two pixels.
#include "mixin/curve.glsl"

float longestOf(sampler2D tiles) {
  ivec2 size = textureSize(tiles, 0);
  float longest = 0.0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) longest = max(longest, lengthOf(vec2(texelFetch(tiles, ivec2(x, y), 0))));
  }
  return longest;
}

float longestCurved() {
  float longest = 0.0;
#if HAS_curve
  ivec2 size = textureSize(longest_tex, 0);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      vec2 d = vec2(texelFetch(longest_tex, ivec2(x, y), 0));
      longest = max(longest, reachOf(d, texelFetch(curve_tex, ivec2(x, y), 0), frame.shutter));
    }
  }
#endif
  return longest;
}

void run(ivec2 pixel) {
  float reach = max(longestOf(longest_tex), longestCurved());
#if HAS_after
  reach = max(reach, longestOf(after_tex));
#endif
#if HAS_revealed
  reach = max(reach, longestOf(revealed_tex));
#endif
#if HAS_revealed_after
  reach = max(reach, longestOf(revealed_after_tex));
#endif
  imageStore(reach_img, pixel, vec4(reach, 0, 0, 0));
}
