// SPDX-License-Identifier: MIT
// Packs a mask into one bit per pixel. First of the three passes of the stream compaction, which turns a mask into a list of
// its pixels.
// In:  `mask`: above 1/2 at masked pixels.
// Out: `bits`: masked pixels of each square of 8x8 pixels, as two words of 32 bits in the order of the pixel list
//        (lib/pixel_list.glsl).
// Method: each invocation reads one square in blocks of 2x2 pixels, and sets one bit per masked pixel.
// Fails: never.
#include "lib/pixel_list.glsl"

// Mask of a block of 2x2 pixels: true for masked pixels, row by row. `first`: upper left pixel of the block. If all four
// pixels are inside the image, one texture gather reads them.
bvec4 maskOf(ivec2 first) {
  ivec2 size = textureSize(mask_tex, 0);
  if (all(lessThan(first + 1, size)))
    return greaterThan(textureGather(mask_tex, vec2(first + 1) / vec2(size)).wzxy, vec4(0.5));
  bvec4 result;
  for (int i = 0; i < 4; ++i) {
    ivec2 at = first + ivec2(i & 1, i >> 1);
    result[i] = all(lessThan(at, size)) && texelFetch(mask_tex, at, 0).r > 0.5;
  }
  return result;
}

// Sets the bit of a pixel of the square if `is` is true. `place`: offset of the pixel from the first pixel of the
// square.
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
      bvec4 four = maskOf(square * params.square_side + place);
      for (int i = 0; i < 4; ++i) add(bits, place + ivec2(i & 1, i >> 1), four[i]);
    }
  imageStore(bits_img, square, uvec4(bits, 0u, 0u));
}
