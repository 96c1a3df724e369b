// SPDX-License-Identifier: MIT
// In:  moving (rgb: mean of the samples at which something that moves is seen, linear; alpha: their number); what is seen at
//      the others: ground (linear) where its alpha is not 0, else color (linear), what the capture sees.
// Out: picture (linear, alpha 1).
#include "lib/mean.glsl"
#include "lib/reached.glsl"
#include "lib/sanitise.glsl"

void run(ivec2 pixel) {
  vec3 picture = finiteColor(texelFetch(color_tex, pixel, 0));
  if (isReached(pixel)) {
    vec4 moving = texelFetch(moving_tex, pixel, 0), behind = texelFetch(ground_tex, pixel, 0);
    vec3 ground = behind.a > 0.0 ? behind.rgb : picture;
    picture = meanOfBoth(moving, vec4(ground, float(params.samples) - moving.a));
    if (moving.a > 0.0) count_samples(uint(moving.a));
  }
  imageStore(picture_img, pixel, vec4(picture, 1));
}
