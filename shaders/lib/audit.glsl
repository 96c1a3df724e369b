// SPDX-License-Identifier: MIT
// Blocks of pixels that trace every ray, to check the rays that others are spared. Drawn by chance, the same each time.
#ifndef STROBE_AUDIT_GLSL
#define STROBE_AUDIT_GLSL
#include "lib/random.glsl"

// Pixels that run as one on a software device: audited together they cost as one.
const ivec2 kAuditBlock = ivec2(4, 2);

bool isAudited(ivec2 block, float share) {
  return float(pcgHash(uint(block.x) ^ pcgHash(uint(block.y))) >> 8) < share * 16777216.0;
}

#endif
