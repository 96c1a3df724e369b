// SPDX-License-Identifier: MIT
// Joins two sets of samples into one.
// In:  `first_a`, `first_b`: first set: rgb: mean linear radiance of each half of the samples; alpha: their number
//      `more_a`, `more_b`: second set: rgb: mean linear radiance of each half of the samples; alpha: their number
//      `first_regions`, `more_regions`: bits 1 inner, 2 hidden, 4 outer, 8 self (lib/regions.glsl)
// Out: `mean_a`, `mean_b`: rgb: mean linear radiance of each half of all samples; alpha: their number
//      `regions`: bits 1 inner, 2 hidden, 4 outer, 8 self
// Method: means weighted by their numbers of samples; regions combined by bitwise or.
// Fails: never.
#include "lib/mean.glsl"

vec4 joined(vec4 first, vec4 more) { return vec4(meanOfBoth(first, more), first.w + more.w); }

void run(ivec2 pixel) {
  imageStore(mean_a_img, pixel, joined(texelFetch(first_a_tex, pixel, 0), texelFetch(more_a_tex, pixel, 0)));
  imageStore(mean_b_img, pixel, joined(texelFetch(first_b_tex, pixel, 0), texelFetch(more_b_tex, pixel, 0)));
  uint regions = texelFetch(first_regions_tex, pixel, 0).x | texelFetch(more_regions_tex, pixel, 0).x;
  imageStore(regions_img, pixel, uvec4(regions, 0u, 0u, 0u));
}
