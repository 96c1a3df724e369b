// SPDX-License-Identifier: MIT
// Adds one time sample to the means of truth; even and odd iterations apart: their difference tells how far off the mean
// of both can be.
// In:  color (linear).  Updates: mean_a, mean_b (rgb: mean linear radiance, a: number of samples).
#include "lib/mean.glsl"

void run(ivec2 pixel) {
  vec3 color = vec3(texelFetch(color_tex, pixel, 0));
  if ((frame.iteration & 1u) == 0u) imageStore(mean_a_img, pixel, withSample(imageLoad(mean_a_img, pixel), color));
  else imageStore(mean_b_img, pixel, withSample(imageLoad(mean_b_img, pixel), color));
}
