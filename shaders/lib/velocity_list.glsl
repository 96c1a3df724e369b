// SPDX-License-Identifier: MIT
// Lists of displacements per tile, two to a texel.
#ifndef STROBE_MOTIONS_GLSL
#define STROBE_MOTIONS_GLSL

const int kMaxVelocities = 8;  // entries per tile

// Marks an unused entry. Displacements, which are limited to image widths, stay far below.
const float kNoVelocity = 1e9;

// True if the entry holds a displacement.
bool isVelocity(vec2 d) { return d.x < 0.5 * kNoVelocity; }

#endif
