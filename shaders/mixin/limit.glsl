// SPDX-License-Identifier: MIT
// Needs: params.limit; may have: max_displacement_buf, max_displacement_post_buf, revealed_max_displacement_buf,
//   revealed_max_displacement_post_buf.
// Longest displacement that a filter handles, and bound of the distance within which it searches. With limit = auto, stored as
// a negative number, no displacement is shortened, and the bound is the longest displacement in the image.
#ifndef STROBE_LIMIT_GLSL
#define STROBE_LIMIT_GLSL
#include "lib/blur.glsl"

const float kNoLimit = 1e18;   // px; its square is finite
const float kMostReach = 1e6;  // px; bound for paths through the near plane, so that numbers of tiles fit an integer

// Limit of the lengths of displacements, px over the exposure. Longer ones are shortened.
float limitPx() { return params.limit < 0.0 ? kNoLimit : params.limit * float(frame.size.x); }

// Upper bound of the lengths of displacements, px over the exposure. If no pass has measured the longest one: twice the
// diagonal of the image.
float reachPx() {
  if (params.limit >= 0.0) return limitPx();
#if HAS_max_displacement
  uint bits = max_displacement_buf.entries[0];  // of a float from 0 on, as those below
#if HAS_max_displacement_post
  bits = max(bits, max_displacement_post_buf.entries[0]);
#endif
#if HAS_revealed_max_displacement
  bits = max(bits, revealed_max_displacement_buf.entries[0]);
#endif
#if HAS_revealed_max_displacement_post
  bits = max(bits, revealed_max_displacement_post_buf.entries[0]);
#endif
  return min(uintBitsToFloat(bits), kMostReach);
#else
  return 2.0 * lengthOf(vec2(frame.size));
#endif
}

#endif
