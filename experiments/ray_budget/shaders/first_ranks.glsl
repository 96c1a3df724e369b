// SPDX-License-Identifier: MIT
// Pixels ahead of a rank.
// In:  rank (lib/rank.glsl), limit (one texel).  Out: mask, 1 where rank is above it. Nothing of rank 0 is.
void run(ivec2 pixel) {
  bool ahead = texelFetch(rank_tex, pixel, 0).x > texelFetch(limit_tex, ivec2(0), 0).x;
  imageStore(mask_img, pixel, vec4(ahead ? 1 : 0));
}
