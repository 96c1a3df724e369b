// SPDX-License-Identifier: MIT
// Mean of moving and static surfaces over all time samples (Haeberli and Akeley 1990, "The Accumulation Buffer").
// In:  `moving`: rgb: mean linear radiance of the samples that show a moving surface; alpha: number of these samples.
//      `static_background`: rgb: linear radiance of the static background behind a moving surface of the raster layer; alpha 0
//        elsewhere.
//      `color`: linear radiance of the raster layer.
// Out: `picture`: linear radiance, alpha 1.
// Method: the alpha of `moving` is the number of samples, out of `samples`, that show a moving surface; all others show
//   the static surface. The radiance of the static surface is `static_background` or, where `static_background` has the
//   alpha 0, `color`. The picture is the mean of the moving and the static radiance, weighted by their numbers of
//   samples. Outside the rectangle that moving surfaces can reach within the exposure (`frame.moving_rect`), the
//   picture is `color`.
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
