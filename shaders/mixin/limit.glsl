// SPDX-License-Identifier: MIT
// Needs: params.limit; may have: reach_tex.
// The longest displacement that a filter handles, and how far from a pixel it must look for it. With limit = auto, which
// is held as a negative number, nothing is shortened, and a filter looks as far as anything moves.
#ifndef STROBE_LIMIT_GLSL
#define STROBE_LIMIT_GLSL
#include "lib/blur.glsl"

const float kNoLimit = 1e18;   // its square is a finite number
const float kMostReach = 1e6;  // of what passes the near plane, px: still an integer number of tiles

// Longer displacements are shortened to it, px over the exposure.
float limitPx() { return params.limit < 0.0 ? kNoLimit : params.limit * float(frame.size.x); }

// No displacement is longer, px over the exposure. Where nobody has measured that: one across the picture.
float reachPx() {
  if (params.limit >= 0.0) return limitPx();
#if HAS_reach
  return min(texelFetch(reach_tex, ivec2(0), 0).x, kMostReach);
#else
  return 2.0 * lengthOf(vec2(frame.size));
#endif
}

#endif
