// SPDX-License-Identifier: MIT
// A mask that is the same everywhere: nothing revealed, or everything.
void run(ivec2 pixel) {
#if PARAM_everywhere
  imageStore(mask_img, pixel, vec4(1));
#else
  imageStore(mask_img, pixel, vec4(0));
#endif
}
