// SPDX-License-Identifier: MIT
// Constant mask: reveals no pixel, or every pixel.
// In:  none.
// Out: mask: 1 everywhere with `everywhere`, otherwise 0.
// Method: stores the value of the parameter.
// Fails: everywhere costs one ray per pixel; nowhere leaves the disocclusions of every silhouette unrevealed.
void run(ivec2 pixel) {
#if PARAM_everywhere
  imageStore(mask_img, pixel, vec4(1));
#else
  imageStore(mask_img, pixel, vec4(0));
#endif
}
