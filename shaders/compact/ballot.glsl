// SPDX-License-Identifier: MIT
// Packs a mask into one bit per pixel: first of the three passes of the stream compaction.
// In:  mask: > 1/2 where set.
// Out: bits: masked pixels of each square of 8x8, two words of 32 bits in the order of the list (lib/pixel_list.glsl).
// Method: reads 2x2 pixels at a time.
// Fails: never.
#include "lib/pixel_list.glsl"

// Mask of 2x2 pixels, with `masked` the upper left one. One gather if all four are inside the image.
bvec4 maskedFrom(ivec2 masked) {
  ivec2 size = textureSize(mask_tex, 0);
  if (all(lessThan(masked + 1, size)))
    return greaterThan(textureGather(mask_tex, vec2(masked + 1) / vec2(size)).wzxy, vec4(0.5));
  bvec4 result;
  for (int i = 0; i < 4; ++i) {
    ivec2 at = masked + ivec2(i & 1, i >> 1);
    result[i] = all(lessThan(at, size)) && texelFetch(mask_tex, at, 0).r > 0.5;
  }
  return result;
}

void add(inout uvec2 bits, ivec2 place, bool is) {
  uint number = pixelNumber(place), bit = uint(is) << (number & 31u);
  if (number < 32u) bits.x |= bit;
  else bits.y |= bit;
}

void run(ivec2 square) {
  uvec2 bits = uvec2(0u);
  for (int y = 0; y < kSquareSide; y += 2)
    for (int x = 0; x < kSquareSide; x += 2) {
      ivec2 place = ivec2(x, y);
      bvec4 four = maskedFrom(square * params.square_side + place);
      for (int i = 0; i < 4; ++i) add(bits, place + ivec2(i & 1, i >> 1), four[i]);
    }
  imageStore(bits_img, square, uvec4(bits, 0u, 0u));
}
