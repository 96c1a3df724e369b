// SPDX-License-Identifier: MIT
// Constant mask: all pixels or no pixels.
// In:  none.
// Out: `mask`: 1 at all pixels with `everywhere`, otherwise 0.
// Method: store the value of the parameter `everywhere`.
// Fails: with `everywhere` every pixel costs one ray. Without it no background is revealed, and disoccluded surfaces are
//   missing.
void run(ivec2 pixel) {
#if PARAM_everywhere
  imageStore(mask_img, pixel, vec4(1));
#else
  imageStore(mask_img, pixel, vec4(0));
#endif
}
