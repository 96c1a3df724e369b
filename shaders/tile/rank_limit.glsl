// SPDX-License-Identifier: MIT
// How far down the ranks (lib/rank.glsl) a share of the pixels goes: first by groups, then by the ranks of one group.
// In:  rank (for the size of the picture), counts (of rank_counts.glsl); group (x the group, y the pixels ahead of it;
//      absent: counts are those of groups).
// Out: limit (x the first group or rank that goes beyond the share, y the pixels ahead of it).
#include "lib/rank.glsl"

uint countOf(uint number) {
  uint sum = 0u;
  for (int strip = 0; strip < textureSize(counts_tex, 0).y; ++strip) {
    sum += texelFetch(counts_tex, ivec2(number / 4u, strip), 0)[number % 4u];
  }
  return sum;
}

void run(ivec2 texel) {
  ivec2 size = textureSize(rank_tex, 0);
  uint most = uint(params.most_part * params.most_pixels * float(size.x * size.y)), ahead = 0u, first = 0u;
#if HAS_group
  uvec2 group = texelFetch(group_tex, ivec2(0), 0).xy;
  ahead = group.y;
  first = group.x * kGroup;
#endif
  // Of each group or rank, from the last down: do all of it fit too?
  int number = int(kGroup) - 1;
  for (; number >= 0; --number) {
    uint more = countOf(uint(number));
    if (more > most - ahead) break;
    ahead += more;
  }
  imageStore(limit_img, texel, uvec4(uint(max(number, 0)) + first, ahead, 0u, 0u));
}
