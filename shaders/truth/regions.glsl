// SPDX-License-Identifier: MIT
// Image regions for the report of errors, from the surfaces that the time samples of ground truth hit.
// In:  `regions`: region bits of all samples (lib/regions.glsl), combined by bitwise or
// Out: `inner`: 1 if a sample hits another, farther instance than the raster layer shows at the pixel
//      `hidden`: 1 if a sample hits a point that is occluded at the raster time
//      `outer`: 1 if a sample hits another, nearer instance than the raster layer shows at the pixel
//      `self`: 1 if a sample hits an occluded point of the instance that the raster layer shows at the pixel
// Method: write each bit to its own image.
// Fails: never.
#include "lib/regions.glsl"

vec4 has(uint met, uint bit) { return vec4((met & bit) != 0u ? 1 : 0); }

void run(ivec2 pixel) {
  uint met = texelFetch(regions_tex, pixel, 0).x;
  imageStore(inner_img, pixel, has(met, kRegionInner));
  imageStore(hidden_img, pixel, has(met, kRegionHidden));
  imageStore(outer_img, pixel, has(met, kRegionOuter));
  imageStore(self_img, pixel, has(met, kRegionSelf));
}
