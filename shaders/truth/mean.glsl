// SPDX-License-Identifier: MIT
// From the sums of two independent halves of the samples to their mean and its error.
// In:  sum_a, sum_b (rgb: summed linear radiance, a: number of samples summed).
// Out: color (mean of all samples, alpha 1), error (rgb: |mean of a - mean of b| / 2, whose root mean square over the
//      picture is the standard error of color; a: number of samples). A half without samples leaves the error 0.
void run(ivec2 pixel) {
  vec4 a = texelFetch(sum_a_tex, pixel, 0);
  vec4 b = texelFetch(sum_b_tex, pixel, 0);
  float count = a.w + b.w;
  vec3 color = count > 0.0 ? vec3(a + b) / count : vec3(0);
  vec3 error = a.w > 0.0 && b.w > 0.0 ? 0.5 * abs(vec3(a) / a.w - vec3(b) / b.w) : vec3(0);
  imageStore(color_img, pixel, vec4(color, 1));
  imageStore(error_img, pixel, vec4(error, count));
}
