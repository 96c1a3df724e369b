// SPDX-License-Identifier: MIT
// How many pixels have each rank (lib/rank.glsl), by strips of the picture: every kStrips-th of its rows.
// In:  rank; group (one texel, absent: groups are counted instead).
// Out: counts (a row for each strip; four groups, or ranks of that group, to a texel).
#include "lib/rank.glsl"

// Which of the numbers that are counted a rank is; none of them: kGroup or more.
uint numberOf(uint rank) {
#if HAS_group
  uint first = texelFetch(group_tex, ivec2(0), 0).x * kGroup;
  return rank < first ? kGroup : rank - first;
#else
  return rank / kGroup;
#endif
}

void run(ivec2 texel) {
  ivec2 size = textureSize(rank_tex, 0);
  uvec4 counts = uvec4(0u);
  for (int y = texel.y; y < size.y; y += pass_size().y) {
    for (int x = 0; x < size.x; ++x) {
      uint number = numberOf(texelFetch(rank_tex, ivec2(x, y), 0).x);
      counts += uvec4(equal(uvec4(number), uint(4 * texel.x) + uvec4(0u, 1u, 2u, 3u)));
    }
  }
  imageStore(counts_img, texel, counts);
}
