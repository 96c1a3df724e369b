// SPDX-License-Identifier: MIT
// Random numbers as hashes of (seed, frame, pixel, iteration, dimension), and points of a scrambled Sobol sequence.
#ifndef STROBE_RANDOM_GLSL
#define STROBE_RANDOM_GLSL

// PCG output permutation (Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 2020).
uint pcgHash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// Random word for a pixel. `iteration`: number of the sample. `dimension`: distinguishes the random numbers of one sample.
uint randomUint(uint pixel, uint iteration, uint dimension) {
  return pcgHash(frame.seed ^ pcgHash(frame.frame ^ pcgHash(pixel ^ pcgHash(iteration ^ pcgHash(dimension)))));
}

// Owen scrambling of a value in [0, 2^32) by a hash: for each bit, the seed and the higher bits decide if the bit is flipped
// (Laine and Karras 2011; Burley, "Practical Hash-based Owen Scrambling", JCGT 2020; multipliers by Vegdahl).
uint scrambled(uint value, uint seed) {
  uint x = bitfieldReverse(value);
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16u) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return bitfieldReverse(x);
}

// Point `number` of a two-dimensional Sobol sequence in [0, 1)^2, with its own scrambling for each pixel. The first n points
// are evenly spread over the square. With number / n as the third coordinate, they are also evenly spread in three dimensions,
// for example over the pixel and the exposure.
vec2 stratified2(uint pixel, uint number) {
  uvec2 point = uvec2(0u), bit = uvec2(0x80000000u);
  for (uint rest = number; rest != 0u; rest >>= 1u) {
    if ((rest & 1u) != 0u) point ^= bit;
    bit = uvec2(bit.x >> 1u, bit.y ^ (bit.y >> 1u));
  }
  uint x = scrambled(point.x, randomUint(pixel, 0u, 1u)), y = scrambled(point.y, randomUint(pixel, 0u, 2u));
  return vec2(x >> 8u, y >> 8u) * (1.0 / 16777216.0);
}

// Half of the Sobol sequence, 0 or 1, that contains point `number`. Ground truth compares the means of both halves. The
// half is 1 if an odd number of the bits 0, 1, 3, 4, 6, 7, ... of `number` are set (all bits but 2, 5, 8, ...). The
// highest bits of the coordinates are parities of other sets of bits, so that each half is spread nearly as evenly as
// the whole sequence.
uint stratifiedHalf(uint number) { return uint(bitCount(number & 0xdb6db6dbu)) & 1u; }

#endif
