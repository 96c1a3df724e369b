// SPDX-License-Identifier: MIT
// Joins two sets of time samples of ground truth into one set.
// In:  `first_a`, `first_b`: first set: rgb: mean linear radiance of each half of the samples; alpha: number of samples
//      `more_a`, `more_b`: second set: rgb: mean linear radiance of each half of the samples; alpha: number of samples
//      `first_regions`, `more_regions`: regions of each set for the report of errors, bits 1 inner, 2 hidden, 4 outer, 8 self
//        (lib/regions.glsl)
// Out: `mean_a`, `mean_b`: rgb: mean linear radiance of each half of all samples; alpha: number of samples
//      `regions`: regions of all samples, with the bits of the inputs
// Method: weight the means by the numbers of samples; combine the regions by bitwise or.
// Fails: never.
#include "lib/mean.glsl"

vec4 joined(vec4 first, vec4 more) { return vec4(meanOfBoth(first, more), first.w + more.w); }

void run(ivec2 pixel) {
  imageStore(mean_a_img, pixel, joined(texelFetch(first_a_tex, pixel, 0), texelFetch(more_a_tex, pixel, 0)));
  imageStore(mean_b_img, pixel, joined(texelFetch(first_b_tex, pixel, 0), texelFetch(more_b_tex, pixel, 0)));
  uint regions = texelFetch(first_regions_tex, pixel, 0).x | texelFetch(more_regions_tex, pixel, 0).x;
  imageStore(regions_img, pixel, uvec4(regions, 0u, 0u, 0u));
}
