// SPDX-License-Identifier: MIT
// Per-pixel noise in [0, 1). Everything is a function of pixel, frame and seed: no clock, no state, no texture.
#ifndef STROBE_NOISE_GLSL
#define STROBE_NOISE_GLSL
#include "lib/random.glsl"

// Interleaved gradient noise, Jimenez 2014; (1,0) .555713, (0,1) .309269, (1,1) .864983, (7,3) .817801.
float gradientNoise(ivec2 pixel) {
  return fract(52.9829189 * fract(0.06711056 * float(pixel.x) + 0.00583715 * float(pixel.y)));
}

// The upper 24 bits, which a float holds exactly.
float unitFromBits(uint bits) { return float(bits >> 8u) / 16777216.0; }

// x / 1.3247... + y / 1.3247...^2 modulo 1, the lattice of the R2 sequence (Roberts 2018), as 32-bit fixed point.
float latticeNoise(ivec2 pixel) { return unitFromBits(uint(pixel.x) * 3242174889u + uint(pixel.y) * 2447445414u); }

uint pixelHash(ivec2 pixel, uint key) { return pcgHash(uint(pixel.x) ^ pcgHash(uint(pixel.y) ^ key)); }

uint noiseKey(uint frame_number, uint seed) { return pcgHash(frame_number ^ pcgHash(seed)); }

float hashNoise(ivec2 pixel, uint frame_number, uint seed) {
  return unitFromBits(pixelHash(pixel, noiseKey(frame_number, seed)));
}

// The rank of the pixel's hash among those of the 5 x 5 pixels around it, and another hash within the rank. Each rank
// is as likely as any other, so the values are uniform; and of two pixels within reach one counts for one of them or
// the other, so the ranks of a region add up to a constant but for its border: low frequencies vanish.
float rankNoise(ivec2 pixel, uint seed) {
  uint key = noiseKey(0u, seed);
  uint own = pixelHash(pixel, key);
  int rank = 0;
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) rank += pixelHash(pixel + ivec2(x, y), key) < own ? 1 : 0;
  }
  return (float(rank) + unitFromBits(pcgHash(own))) / 25.0;
}

#endif
