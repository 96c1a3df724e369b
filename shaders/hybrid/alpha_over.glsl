// SPDX-License-Identifier: MIT
// Composite of the blurred raster layer over the blurred revealed layer (Porter and Duff 1984).
// In:  `front`: blurred raster layer, linear radiance times alpha; alpha is 1 where no surface was revealed behind the pixel.
//      `back`: blurred revealed layer, linear radiance.
// Out: `color`: linear radiance, alpha 1.
// Method: color = front + (1 - alpha) * back, with the alpha of `front`. Where alpha is 1, `color` equals `front`, bit for bit.
//   With an empty mask the pipeline `hybrid` therefore equals the plain gather.
//   The result is exact where coverage and background colour are uncorrelated over time, for example over a static background.
// Fails: wrong where a textured background moves under a moving silhouette: the product of two means is not the mean of the
//   product (errors up to 0.2 with perfect layers; docs/derivations.md, "Alpha-over").
#include "lib/sanitise.glsl"

void run(ivec2 pixel) {
  vec4 front = texelFetch(front_tex, pixel, 0);
  vec3 color = vec3(front);
  if (front.w < 1.0) color += (1.0 - front.w) * finiteColor(texelFetch(back_tex, pixel, 0));
  imageStore(color_img, pixel, vec4(color, 1));
}
