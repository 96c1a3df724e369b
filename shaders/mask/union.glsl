// SPDX-License-Identifier: MIT
// Union of two masks.
// In:  `first`, `second`: masks, above 1/2 at masked pixels.
// Out: `mask`: 1 at pixels that are in `first` or in `second`, otherwise 0.
// Method: logical or per pixel.
// Fails: misses the pixels that both masks miss.
void run(ivec2 pixel) {
  bool set = texelFetch(first_tex, pixel, 0).x > 0.5 || texelFetch(second_tex, pixel, 0).x > 0.5;
  imageStore(mask_img, pixel, vec4(set ? 1 : 0));
}
