// SPDX-License-Identifier: MIT
// Which pixels of each square of 8x8 are masked.
// In:  mask.
// Out: bits, a texel for each square (lib/listed.glsl).
#include "lib/listed.glsl"

// Four pixels at a time, the left upper one of which is `masked`: one gather where the picture has them all.
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
  uint number = listedNumber(place), bit = uint(is) << (number & 31u);
  if (number < 32u) bits.x |= bit;
  else bits.y |= bit;
}

void run(ivec2 square) {
  uvec2 bits = uvec2(0u);
  for (int y = 0; y < kListedSide; y += 2)
    for (int x = 0; x < kListedSide; x += 2) {
      ivec2 place = ivec2(x, y);
      bvec4 four = maskedFrom(square * params.listed_side + place);
      for (int i = 0; i < 4; ++i) add(bits, place + ivec2(i & 1, i >> 1), four[i]);
    }
  imageStore(bits_img, square, uvec4(bits, 0u, 0u));
}
