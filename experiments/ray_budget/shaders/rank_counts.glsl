// SPDX-License-Identifier: MIT
// How many pixels have each rank (lib/rank.glsl): every invocation adds a share of the picture to what all count.
// In:  rank.
// Out: counts (an entry for each rank; of rank 0, which nothing comes behind, none).
#include "lib/rank.glsl"

void run(ivec2 own) {
  ivec2 size = textureSize(rank_tex, 0);
  int pixels = size.x * size.y, step_px = pass_size().x * pass_size().y;
  for (int i = own.y * pass_size().x + own.x; i < pixels; i += step_px) {
    uint rank = texelFetch(rank_tex, ivec2(i % size.x, i / size.x), 0).x;
    if (rank > 0u) atomicAdd(counts_buf.entries[min(rank, kRanks - 1u)], 1u);
  }
}
