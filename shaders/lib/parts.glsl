// SPDX-License-Identifier: MIT
// Sets of time strata: one bit for each of at most 64 parts of the exposure, in two words of 32 bits.
#ifndef STROBE_PARTS_GLSL
#define STROBE_PARTS_GLSL

const int kMostParts = 64;

uvec2 partBit(int part) { return part < 32 ? uvec2(1u << uint(part), 0u) : uvec2(0u, 1u << uint(part - 32)); }

// Word with the lowest `count` bits set. A negative count gives 0, a count above 32 gives all bits.
uint firstBits(int count) { return count <= 0 ? 0u : count < 32 ? (1u << uint(count)) - 1u : ~0u; }

// Set of the first `count` parts.
uvec2 allParts(int count) { return uvec2(firstBits(count), firstBits(count - 32)); }

int countParts(uvec2 parts) { return bitCount(parts.x) + bitCount(parts.y); }

bool hasParts(uvec2 parts) { return (parts.x | parts.y) != 0u; }

// Number of the first part in a set. The set must not be empty.
int firstPart(uvec2 parts) { return parts.x != 0u ? findLSB(parts.x) : 32 + findLSB(parts.y); }

#endif
