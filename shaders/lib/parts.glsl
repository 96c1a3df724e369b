// SPDX-License-Identifier: MIT
// Sets of at most 64 parts of the exposure, one bit for each part.
#ifndef STROBE_PARTS_GLSL
#define STROBE_PARTS_GLSL

const int kMostParts = 64;

uvec2 partBit(int part) { return part < 32 ? uvec2(1u << uint(part), 0u) : uvec2(0u, 1u << uint(part - 32)); }

// Word with its lowest `count` bits set; a negative count is 0, a count above 32 is 32.
uint firstBits(int count) { return count <= 0 ? 0u : count < 32 ? (1u << uint(count)) - 1u : ~0u; }

// Set of the first `count` parts.
uvec2 allParts(int count) { return uvec2(firstBits(count), firstBits(count - 32)); }

int countParts(uvec2 parts) { return bitCount(parts.x) + bitCount(parts.y); }

bool hasParts(uvec2 parts) { return (parts.x | parts.y) != 0u; }

// Number of the first part in a set. The set must not be empty.
int firstPart(uvec2 parts) { return parts.x != 0u ? findLSB(parts.x) : 32 + findLSB(parts.y); }

#endif
