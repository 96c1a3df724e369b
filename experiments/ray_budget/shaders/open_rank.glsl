// SPDX-License-Identifier: MIT
// The rank of pixels by what rays at their own time are expected to gain. Who had a ray comes first: more are free.
// In:  open (bits), guess (alpha: by how much it may be off), mask (> 1/2 where a ray was).
// Out: rank (lib/rank.glsl).
#include "lib/rank.glsl"

void run(ivec2 pixel) {
  uvec2 open = texelFetch(open_tex, pixel, 0).xy;
  uint rank = (open.x | open.y) != 0u ? rankOf(texelFetch(guess_tex, pixel, 0).a) : 0u;
  if (texelFetch(mask_tex, pixel, 0).x > 0.5) rank = kFirstRank;
  imageStore(rank_img, pixel, uvec4(rank));
}
