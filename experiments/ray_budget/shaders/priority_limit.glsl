// SPDX-License-Identifier: MIT
// Threshold of the priority (lib/priority.glsl) above which at most a share of the pixels lie.
// In:  priority: priority; only its size is read.
//      counts: histogram of rank_counts.glsl.
// Out: limit: the largest priority that would exceed the share; 0 if all fit.
// Fails: selects all pixels of one priority or none.
#include "lib/priority.glsl"

void run(ivec2 texel) {
  ivec2 size = textureSize(priority_tex, 0);
  uint left = uint(params.most_part * params.most_pixels * float(size.x * size.y)), priority = kFirstRank;
  for (; priority > 0u; --priority) {
    uint more = counts_buf.entries[priority];
    if (more > left) break;
    left -= more;
  }
  imageStore(limit_img, texel, uvec4(priority, 0u, 0u, 0u));
}
