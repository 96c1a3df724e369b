// SPDX-License-Identifier: MIT
// Adds one time sample to one of two running means, each over half of the samples (Haeberli and Akeley 1990, "The Accumulation
// Buffer").
// In:  `color`: linear radiance at one time
// Out: `mean_a`, `mean_b`: updated; rgb: mean linear radiance of the samples of even iterations (`mean_a`) and of odd
//        iterations (`mean_b`); alpha: number of samples
// Method: running mean (lib/mean.glsl). There are two means because their difference gives the error of the mean of all samples
//   (truth/mean.glsl).
// Fails: never.
#include "lib/mean.glsl"

void run(ivec2 pixel) {
  vec3 color = vec3(texelFetch(color_tex, pixel, 0));
  if ((frame.iteration & 1u) == 0u) imageStore(mean_a_img, pixel, withSample(imageLoad(mean_a_img, pixel), color));
  else imageStore(mean_b_img, pixel, withSample(imageLoad(mean_b_img, pixel), color));
}
