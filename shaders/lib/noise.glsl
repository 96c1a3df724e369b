// SPDX-License-Identifier: MIT
// Noise per pixel in [0, 1), as pure functions of pixel, frame number and seed, so that each picture can be repeated exactly.
#ifndef STROBE_NOISE_GLSL
#define STROBE_NOISE_GLSL
#include "lib/random.glsl"

// Interleaved gradient noise (Jimenez 2014). To check an implementation: pixel (1,0) has .555713, (0,1) .309269, (1,1) .864983,
// (7,3) .817801.
float gradientNoise(ivec2 pixel) {
  return fract(52.9829189 * fract(0.06711056 * float(pixel.x) + 0.00583715 * float(pixel.y)));
}

// Number in [0, 1) from the upper 24 bits of a word; a float holds 24 bits exactly.
float unitFromBits(uint bits) { return float(bits >> 8u) / 16777216.0; }

// Hash of a pixel. `key`: noiseKey of the frame and the seed.
uint pixelHash(ivec2 pixel, uint key) { return pcgHash(uint(pixel.x) ^ pcgHash(uint(pixel.y) ^ key)); }

uint noiseKey(uint frame_number, uint seed) { return pcgHash(frame_number ^ pcgHash(seed)); }

float hashNoise(ivec2 pixel, uint frame_number, uint seed) {
  return unitFromBits(pixelHash(pixel, noiseKey(frame_number, seed)));
}

#endif
