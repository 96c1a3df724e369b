// SPDX-License-Identifier: MIT
// Lists of displacements per tile or cell, stored in images with two displacements to a texel.
#ifndef STROBE_VELOCITY_LIST_GLSL
#define STROBE_VELOCITY_LIST_GLSL

const int kMaxVelocities = 8;  // entries per list

// x of an unused list entry. Displacements are limited to image widths and stay far below this number.
const float kNoVelocity = 1e9;

// True if the list entry d is a displacement, not an unused entry.
bool isVelocity(vec2 d) { return d.x < 0.5 * kNoVelocity; }

#endif
