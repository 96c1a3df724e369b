// SPDX-License-Identifier: MIT
// Random choice of blocks of pixels for validation. A chosen block traces all its rays, including the rays that other blocks
// replace by known results. The choice is a hash of the block's position alone: the same in every frame and run.
#ifndef STROBE_AUDIT_GLSL
#define STROBE_AUDIT_GLSL
#include "lib/random.glsl"

// Size of a block, pixels. A software device traces the rays of 4x2 pixels together, so a block costs as much as one pixel.
const ivec2 kValidationBlock = ivec2(4, 2);

// True if the block is chosen; `share`: share of all blocks, 0 to 1.
bool isValidated(ivec2 block, float share) {
  return float(pcgHash(uint(block.x) ^ pcgHash(uint(block.y))) >> 8) < share * 16777216.0;
}

#endif
