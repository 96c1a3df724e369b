// SPDX-License-Identifier: MIT
// Adds one time sample to the sums of truth; even and odd iterations apart: their difference tells how far off their
// mean can be.
// In:  color (linear).  Updates: sum_a, sum_b (rgb: summed linear radiance, a: number of samples summed).
void run(ivec2 pixel) {
  vec4 added = vec4(vec3(texelFetch(color_tex, pixel, 0)), 1);
  if ((frame.iteration & 1u) == 0u) imageStore(sum_a_img, pixel, imageLoad(sum_a_img, pixel) + added);
  else imageStore(sum_b_img, pixel, imageLoad(sum_b_img, pixel) + added);
}
