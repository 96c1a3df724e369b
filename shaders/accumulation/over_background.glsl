// SPDX-License-Identifier: MIT
// Mean radiance of moving and static surfaces over the time samples (Haeberli and Akeley 1990, "The Accumulation Buffer").
// In:  `moving`:  rgb: mean linear radiance of the samples that show a moving surface; alpha: their number
//      `static_background`:  rgb: linear radiance of the static background; alpha 0: the static radiance is `color`
//      `color`:   linear radiance at the raster time
// Out: `picture`: linear radiance, alpha 1
// Method: weighted mean of `moving` and, for the other of `samples` samples, `static_background` or `color`. Outside the moving
//      rectangle the output is `color`.
// Fails: static surfaces keep the shadows of the raster time.
#include "lib/mean.glsl"
#include "lib/moving_rect.glsl"
#include "lib/sanitise.glsl"

void run(ivec2 pixel) {
  vec3 picture = finiteColor(texelFetch(color_tex, pixel, 0));
  if (isInMovingRect(pixel)) {
    vec4 moving = texelFetch(moving_tex, pixel, 0), background = texelFetch(static_background_tex, pixel, 0);
    vec3 static_background = background.a > 0.0 ? background.rgb : picture;
    picture = meanOfBoth(moving, vec4(static_background, float(params.samples) - moving.a));
    if (moving.a > 0.0) count_samples(uint(moving.a));
  }
  imageStore(picture_img, pixel, vec4(picture, 1));
}
