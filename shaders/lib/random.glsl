// SPDX-License-Identifier: MIT
// Random numbers as hashes of (seed, frame, pixel, iteration, dimension).
#ifndef STROBE_RANDOM_GLSL
#define STROBE_RANDOM_GLSL

// PCG output permutation (Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 2020).
uint pcgHash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

uint randomUint(uint pixel, uint iteration, uint dimension) {
  return pcgHash(frame.seed ^ pcgHash(frame.frame ^ pcgHash(pixel ^ pcgHash(iteration ^ pcgHash(dimension)))));
}

// Owen's scrambling, by a hash: each bit is flipped or not as those above it and the seed have it (Laine and Karras 2011;
// Burley, "Practical Hash-based Owen Scrambling", JCGT 2020; multipliers by Vegdahl).
uint scrambled(uint value, uint seed) {
  uint x = bitfieldReverse(value);
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16u) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return bitfieldReverse(x);
}

// Point `number` in [0, 1)^2 of a sequence whose points are evenly spread, as the pixel scrambles it: the first two
// dimensions of Sobol's, with which number / count is evenly spread too as a third.
vec2 stratified2(uint pixel, uint number) {
  uvec2 point = uvec2(0u), bit = uvec2(0x80000000u);
  for (uint rest = number; rest != 0u; rest >>= 1u) {
    if ((rest & 1u) != 0u) point ^= bit;
    bit = uvec2(bit.x >> 1u, bit.y ^ (bit.y >> 1u));
  }
  uint x = scrambled(point.x, randomUint(pixel, 0u, 1u)), y = scrambled(point.y, randomUint(pixel, 0u, 2u));
  return vec2(x >> 8u, y >> 8u) * (1.0 / 16777216.0);
}

// In which of two halves of these points the point is, 0 or 1. Bits of the number that no coordinate's highest bits are
// made of decide, so that each half is as evenly spread as the whole.
uint stratifiedHalf(uint number) { return uint(bitCount(number & 0xdb6db6dbu)) & 1u; }

#endif
