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

// Low-discrepancy points of [0, 1)^2 over the iterations, shifted per pixel (the R2 sequence of Roberts; its steps are
// powers of 1/1.32471795724, here as 32-bit fixed point).
vec2 stratified2(uint pixel, uint iteration) {
  uint x = randomUint(pixel, 0u, 1u) + iteration * 3242174889u;
  uint y = randomUint(pixel, 0u, 2u) + iteration * 2447445414u;
  return vec2(x >> 8u, y >> 8u) * (1.0 / 16777216.0);
}

#endif
