// SPDX-License-Identifier: MIT
// Clears an image to zero (runtime/graph/clears.cpp).
void run(ivec2 pixel) {
#if PARAM_is_uint
  imageStore(cleared_img, pixel, uvec4(0u));
#else
  imageStore(cleared_img, pixel, vec4(0));
#endif
}
