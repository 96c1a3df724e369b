// SPDX-License-Identifier: MIT
// From the means of two independent halves of the samples to their mean and its error.
// In:  mean_a, mean_b (rgb: mean linear radiance, a: number of samples).
// Out: color (mean of all samples, alpha 1), error (rgb: |mean of a - mean of b| / 2, whose root mean square over the
//      picture is the standard error of color; a: number of samples). A half without samples leaves the error 0.
#include "lib/mean.glsl"

void run(ivec2 pixel) {
  vec4 a = texelFetch(mean_a_tex, pixel, 0);
  vec4 b = texelFetch(mean_b_tex, pixel, 0);
  vec3 error = a.w > 0.0 && b.w > 0.0 ? 0.5 * abs(a.rgb - b.rgb) : vec3(0);
  imageStore(color_img, pixel, vec4(meanOfBoth(a, b), 1));
  imageStore(error_img, pixel, vec4(error, a.w + b.w));
}
