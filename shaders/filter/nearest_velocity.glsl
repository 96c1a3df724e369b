// SPDX-License-Identifier: MIT
// Per pixel, the displacement of the nearest surface in the 3x3 pixels around it.
// In:  `velocity`: displacement of the surface at each pixel, px over the exposure.
//      `depth`: view depth, metres; +inf for the sky.
// Out: `nearest`: displacement of the pixel with the least depth of 3x3, px over the exposure.
// Method: keep the pixel's own displacement unless a neighbour is nearer. Of equally near neighbours the first in raster order
//   wins.
// Fails: a pixel beside a silhouette gets the displacement of another surface than it shows.
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

void run(ivec2 pixel) {
  ivec2 nearest = pixel;
  float least = saneDepth(depth_at(pixel).x);
  for (int i = 0; i < 9; ++i) {
    ivec2 at = clampToImage(pixel + ivec2(i % 3, i / 3) - 1, pass_size());
    float depth = saneDepth(depth_at(at).x);
    if (depth < least) nearest = at, least = depth;
  }
  imageStore(nearest_img, pixel, velocity_at(nearest));
}
