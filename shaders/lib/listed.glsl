// SPDX-License-Identifier: MIT
// Squares of 8x8 pixels that a list is made of: which of them are on it, as 64 bits.
#ifndef STROBE_LISTED_GLSL
#define STROBE_LISTED_GLSL

const int kListedSide = 8;

// The pixels of a square in the order of the list: that in which eight invocations take 4x2 of them, whose rays are closer
// than those of a row. Bit i of the two words stands for place i.
uint listedNumber(ivec2 place) { return uint((place.x >> 2) + (place.y >> 1) * 2) * 8u + uint((place.y & 1) * 4 + (place.x & 3)); }
ivec2 listedPlace(uint i) {
  ivec2 block = ivec2(i >> 3 & 1u, i >> 4);
  return block * ivec2(4, 2) + ivec2(i & 3u, i >> 2 & 1u);
}

uint listedCount(uvec2 bits) { return uint(bitCount(bits.x) + bitCount(bits.y)); }

#endif
