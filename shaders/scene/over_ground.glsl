// SPDX-License-Identifier: MIT
// In:  moving (rgb: mean of the samples at which something that moves is seen, linear; alpha: their number), ground (linear,
//      what is seen at the others).
// Out: picture (linear, alpha 1).
#include "lib/mean.glsl"

void run(ivec2 pixel) {
  vec4 moving = texelFetch(moving_tex, pixel, 0);
  if (moving.a > 0.0) count_samples(uint(moving.a));
  vec4 rest = vec4(texelFetch(ground_tex, pixel, 0).rgb, float(params.samples) - moving.a);
  imageStore(picture_img, pixel, vec4(meanOfBoth(moving, rest), 1));
}
