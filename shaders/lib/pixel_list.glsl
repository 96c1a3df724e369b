// SPDX-License-Identifier: MIT
// Masks of squares of 8x8 pixels, packed into 64 bits. A bit is set if its pixel is in the pixel list; the pixels of a list are
// in the order of these bits.
#ifndef STROBE_PIXEL_LIST_GLSL
#define STROBE_PIXEL_LIST_GLSL

const int kSquareSide = 8;

// Number of a pixel in its square, 0 to 63: the number of its bit, and its place in the order of the list. `place`: offset from
// the first pixel of the square. Eight successive numbers are a block of 4x2 pixels, because the rays of such a block are
// closer together than the rays of eight pixels in a row.
uint pixelNumber(ivec2 place) {
  return uint((place.x >> 2) + (place.y >> 1) * 2) * 8u + uint((place.y & 1) * 4 + (place.x & 3));
}
// Offset of the pixel with number i from the first pixel of the square. Inverse of pixelNumber.
ivec2 pixelOf(uint i) {
  ivec2 block = ivec2(i >> 3 & 1u, i >> 4);
  return block * ivec2(4, 2) + ivec2(i & 3u, i >> 2 & 1u);
}

// Number of pixels of the square that are in the pixel list.
uint pixelCount(uvec2 bits) { return uint(bitCount(bits.x) + bitCount(bits.y)); }

#endif
