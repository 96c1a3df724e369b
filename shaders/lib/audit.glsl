// SPDX-License-Identifier: MIT
// Tiles that have as many samples as if all had one number, to check those that do not: by chance, the same each time.
#ifndef STROBE_AUDIT_GLSL
#define STROBE_AUDIT_GLSL
#include "lib/random.glsl"

// Pixels that run as one on a software device: audited together they cost as one.
const ivec2 kAuditBlock = ivec2(4, 2);

bool isAudited(ivec2 tile, float share) {
  return float(pcgHash(uint(tile.x) ^ pcgHash(uint(tile.y))) >> 8) < share * 16777216.0;
}

#endif
