// SPDX-License-Identifier: MIT
// Mean of all time samples of ground truth, from the means of two independent halves, and the error of this mean.
// In:  `mean_a`, `mean_b`: rgb: mean linear radiance of each half of the samples; alpha: number of samples
// Out: `color`: mean of all samples, linear radiance; alpha 1
//      `error`: rgb: |mean a - mean b| / 2, linear radiance; alpha: number of all samples
// Method: weight the means of the halves by their numbers of samples. The root mean square of `error` over the image is the
//   standard error of `color`.
// Fails: if a half has no samples, the error is 0 although it is unknown.
#include "lib/mean.glsl"

void run(ivec2 pixel) {
  vec4 a = texelFetch(mean_a_tex, pixel, 0);
  vec4 b = texelFetch(mean_b_tex, pixel, 0);
  vec3 error = a.w > 0.0 && b.w > 0.0 ? 0.5 * abs(a.rgb - b.rgb) : vec3(0);
  imageStore(color_img, pixel, vec4(meanOfBoth(a, b), 1));
  imageStore(error_img, pixel, vec4(error, a.w + b.w));
}
