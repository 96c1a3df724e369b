// SPDX-License-Identifier: MIT
// A short list of displacements per tile, two to a texel.
#ifndef STROBE_MOTIONS_GLSL
#define STROBE_MOTIONS_GLSL

const int kMaxMotions = 8;

// Stands for "none" in a list; no displacement, limited to image widths, comes near.
const float kNoMotion = 1e9;

bool isMotion(vec2 d) { return d.x < 0.5 * kNoMotion; }

#endif
