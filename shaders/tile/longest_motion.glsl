// SPDX-License-Identifier: MIT
// The length of the longest displacement of the whole picture, from those of its tiles.
// In:  longest, after, revealed, revealed_after (xy: px over the exposure, longest of each tile; absent: nothing).
//      curve (of the paths of longest, px; absent: lines): a curved one is as long as the straight one that comes as far.
// Out: reach (px over the exposure), one texel.
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
