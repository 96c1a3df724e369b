// SPDX-License-Identifier: MIT
// Per-pixel jitter. Everything is a function of pixel, frame and seed: no clock, no state.
#ifndef STROBE_NOISE_GLSL
#define STROBE_NOISE_GLSL

// Interleaved gradient noise in [0, 1), Jimenez 2014; (1,0) .555713, (0,1) .309269, (1,1) .864983, (7,3) .817801.
float gradientNoise(ivec2 pixel) {
  return fract(52.9829189 * fract(0.06711056 * float(pixel.x) + 0.00583715 * float(pixel.y)));
}

// PCG (O'Neill 2014), output permutation RXS-M-XS on 32 bits.
uint hashOf(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// In [0, 1): the upper 24 bits, which a float holds exactly.
float hashNoise(ivec2 pixel, uint frame_number, uint seed) {
  uint bits = hashOf(uint(pixel.x) ^ hashOf(uint(pixel.y) ^ hashOf(frame_number ^ hashOf(seed))));
  return float(bits >> 8u) / 16777216.0;
}

#endif
