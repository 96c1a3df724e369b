// SPDX-License-Identifier: MIT
// Random choice of blocks of pixels for validation. Passes that skip rays with known results trace all rays in a chosen block,
// and compare the results. The choice is a hash of the block's position alone, so all frames and runs validate the same blocks.
#ifndef STROBE_VALIDATION_GLSL
#define STROBE_VALIDATION_GLSL
#include "lib/random.glsl"

// Size of a block, pixels. A software device traces the rays of 4x2 pixels together, so validating a block costs as much as
// validating one of its pixels.
const ivec2 kValidationBlock = ivec2(4, 2);

// True if the block is chosen. `block`: position of the block, in blocks. `share`: share of blocks to choose, 0 to 1.
bool isValidated(ivec2 block, float share) {
  return float(pcgHash(uint(block.x) ^ pcgHash(uint(block.y))) >> 8) < share * 16777216.0;
}

#endif
