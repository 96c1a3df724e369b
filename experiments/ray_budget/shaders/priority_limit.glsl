// SPDX-License-Identifier: MIT
// Threshold on the ray priority of pixels (lib/priority.glsl), which at most a given share of the pixels exceed.
// In:  priority: ray priority of each pixel; only the size of the image is read.
//      counts: histogram from priority_histogram.glsl: entry i is the number of pixels with priority i.
// Out: limit: threshold, one texel: the largest priority that is not selected; 0 if all pixels with a priority above 0 fit.
// Method: from the highest priority downwards, subtract the counts from the allowed number of pixels. The threshold is the
//      first priority with more pixels than the number that is left.
// Fails: selects all pixels of one priority or none, so a part of the share may stay unused.
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
