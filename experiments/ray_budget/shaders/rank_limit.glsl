// SPDX-License-Identifier: MIT
// How far down the ranks (lib/rank.glsl) a share of the pixels goes.
// In:  rank (for the size of the picture), counts (of rank_counts.glsl).
// Out: limit (the first rank that goes beyond the share; 0: none does).
#include "lib/rank.glsl"

void run(ivec2 texel) {
  ivec2 size = textureSize(rank_tex, 0);
  uint left = uint(params.most_part * params.most_pixels * float(size.x * size.y)), rank = kFirstRank;
  for (; rank > 0u; --rank) {
    uint more = counts_buf.entries[rank];
    if (more > left) break;
    left -= more;
  }
  imageStore(limit_img, texel, uvec4(rank, 0u, 0u, 0u));
}
