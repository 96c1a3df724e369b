// SPDX-License-Identifier: MIT
// Marks texels next to a texel with a different displacement: a moving silhouette may lie between the two texels.
// In:  `velocity`: displacement, px over the exposure
//      `velocity_post`: displacement after the raster time, px over the exposure; absent: `velocity`
// Out: `near`: 1 if one of the eight texels around, inside the image, has a different displacement; otherwise 0
// Method: compare the displacements of the texel and of each neighbour by movesOtherwise() (lib/blur.glsl): they are different
//   from a threshold on. The threshold is 5 % of the shorter displacement, at least `slowest` px, and at most 1/2 px (or
//   `slowest`, if that is larger).
// Fails: misses surfaces narrower than a pixel that lie between texels.
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

vec4 motionAt(ivec2 at) {
  return vec4(finiteDisplacement(velocity_at(at)), finiteDisplacement(velocity_post_at(at)));
}

void run(ivec2 pixel) {
  ivec2 size = textureSize(velocity_tex, 0);
  vec4 here = motionAt(pixel);
  bool otherwise = false;
  for (int k = 0; k < 9; ++k) {
    vec4 there = motionAt(clampToImage(pixel + ivec2(k % 3, k / 3) - 1, size));
    if (there == here) continue;
    otherwise = otherwise || movesOtherwise(there.xy, here.xy, params.slowest) ||
                movesOtherwise(there.zw, here.zw, params.slowest);
  }
  if (otherwise) imageStore(near_img, pixel, vec4(1));
}
