// SPDX-License-Identifier: MIT
// Two sets of samples as one: means by their numbers, regions or-ed.
// In:  first_a, first_b, more_a, more_b (rgb mean, a number of samples), first_regions, more_regions (bits).
// Out: mean_a, mean_b, regions.
#include "lib/mean.glsl"

vec4 joined(vec4 first, vec4 more) { return vec4(meanOfBoth(first, more), first.w + more.w); }

void run(ivec2 pixel) {
  imageStore(mean_a_img, pixel, joined(texelFetch(first_a_tex, pixel, 0), texelFetch(more_a_tex, pixel, 0)));
  imageStore(mean_b_img, pixel, joined(texelFetch(first_b_tex, pixel, 0), texelFetch(more_b_tex, pixel, 0)));
  uint regions = texelFetch(first_regions_tex, pixel, 0).x | texelFetch(more_regions_tex, pixel, 0).x;
  imageStore(regions_img, pixel, uvec4(regions, 0u, 0u, 0u));
}
