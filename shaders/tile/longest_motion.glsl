// SPDX-License-Identifier: MIT
// The length of the longest displacement of the whole picture, from those of its tiles.
// In:  longest, after, revealed, revealed_after (xy: px over the exposure, longest of each tile; absent: nothing).
// Out: reach (px over the exposure), one texel.
#include "lib/blur.glsl"

float longestOf(sampler2D tiles) {
  ivec2 size = textureSize(tiles, 0);
  float longest = 0.0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) longest = max(longest, lengthOf(vec2(texelFetch(tiles, ivec2(x, y), 0))));
  }
  return longest;
}

void run(ivec2 pixel) {
  float reach = longestOf(longest_tex);
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
