// SPDX-License-Identifier: MIT
// Front over back: out = front + (1 - alpha) * back (Porter and Duff 1984; front is already multiplied by its alpha).
// In:  front (linear, times alpha; alpha 1 where nothing was revealed behind), back (linear).
// Out: color (linear, alpha 1). Where alpha is 1 it is front, bit for bit: without mask the hybrid is the plain gather.
// Exact where coverage and colours are uncorrelated in time: anything over a background at rest.
// Fails: where a textured background moves under a moving silhouette, the product of their means is not the mean of the
//   product (errors up to 0.2 with perfect layers).
#include "lib/sanitise.glsl"

void run(ivec2 pixel) {
  vec4 front = texelFetch(front_tex, pixel, 0);
  vec3 color = vec3(front);
  if (front.w < 1.0) color += (1.0 - front.w) * finiteColor(texelFetch(back_tex, pixel, 0));
  imageStore(color_img, pixel, vec4(color, 1));
}
