// SPDX-License-Identifier: MIT
// Random sequences as hashes of their indices. The numbers do not depend on the order of the draws.
#pragma once

#include <cstdint>

namespace strobe {

// PCG output permutation (Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 2020).
inline uint32_t pcgHash(uint32_t value) {
  uint32_t state = value * 747796405u + 2891336453u;
  uint32_t word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

// Uniform in [0, 1), 24 bits.
inline double hashUniform(uint32_t seed, uint32_t frame, uint32_t index, uint32_t dimension) {
  uint32_t hash = pcgHash(seed ^ pcgHash(frame ^ pcgHash(index ^ pcgHash(dimension))));
  return (hash >> 8) * (1.0 / 16777216.0);
}

}  // namespace strobe
