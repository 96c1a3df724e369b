// SPDX-License-Identifier: MIT
// Composites the blurred raster layer over the blurred revealed layer (Porter and Duff 1984).
// In:  front: linear radiance times alpha; alpha is 1 where no surface was revealed behind the pixel.
//      back: linear radiance.
// Out: color: linear radiance, alpha 1. Where the alpha of front is 1, color is front, bit for bit. Without a mask the hybrid
//      therefore is the plain gather.
// Method: color = front + (1 - alpha) * back.
//   The result is exact where coverage and colours are uncorrelated over time, for example over a static background.
// Fails: where a textured background moves under a moving silhouette. The product of two means is not the mean of the product
//   (errors up to 0.2 with perfect layers; docs/derivations.md, "Alpha-over").
#include "lib/sanitise.glsl"

void run(ivec2 pixel) {
  vec4 front = texelFetch(front_tex, pixel, 0);
  vec3 color = vec3(front);
  if (front.w < 1.0) color += (1.0 - front.w) * finiteColor(texelFetch(back_tex, pixel, 0));
  imageStore(color_img, pixel, vec4(color, 1));
}
