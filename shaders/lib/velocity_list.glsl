// SPDX-License-Identifier: MIT
// Lists of displacements per tile, two to a texel.
#ifndef STROBE_MOTIONS_GLSL
#define STROBE_MOTIONS_GLSL

const int kMaxVelocities = 8;  // entries per tile

// x of an unused entry. Displacements are limited to image widths and stay far below this number.
const float kNoVelocity = 1e9;

// True if the entry holds a displacement.
bool isVelocity(vec2 d) { return d.x < 0.5 * kNoVelocity; }

#endif
