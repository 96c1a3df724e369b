// SPDX-License-Identifier: MIT
// Union of two masks.
// In:  first: > 1/2 where set.
//      second: > 1/2 where set.
// Out: mask: 1 where first or second is set, otherwise 0.
// Method: logical or per pixel.
// Fails: pixels that both masks miss.
void run(ivec2 pixel) {
  bool set = texelFetch(first_tex, pixel, 0).x > 0.5 || texelFetch(second_tex, pixel, 0).x > 0.5;
  imageStore(mask_img, pixel, vec4(set ? 1 : 0));
}
