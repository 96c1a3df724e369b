// SPDX-License-Identifier: MIT
// The union of two masks.
// In:  first, second (> 1/2 where set).  Out: mask, 1 where one of them is.
void run(ivec2 pixel) {
  bool set = texelFetch(first_tex, pixel, 0).x > 0.5 || texelFetch(second_tex, pixel, 0).x > 0.5;
  imageStore(mask_img, pixel, vec4(set ? 1 : 0));
}
