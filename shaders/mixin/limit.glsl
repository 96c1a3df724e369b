// SPDX-License-Identifier: MIT
// Needs: params.limit; may have: max_displacement_buf, max_displacement_post_buf, revealed_max_displacement_buf,
//   revealed_max_displacement_post_buf.
// Largest length of a filter's displacements, and bound of the distance within which the filter looks for surfaces. With
// `limit` = auto, stored as a negative number, no displacement is shortened, and the bound is the longest displacement in the
// image.
#ifndef STROBE_LIMIT_GLSL
#define STROBE_LIMIT_GLSL
#include "lib/blur.glsl"

const float kNoLimit = 1e18;   // px; its square is finite
const float kMostReach = 1e6;  // px; bounds paths through the near plane, so that their number of tiles fits an integer

// Largest length of a displacement, px over the exposure. Longer displacements are shortened to this length.
float limitPx() { return params.limit < 0.0 ? kNoLimit : params.limit * float(frame.size.x); }

// Upper bound of the lengths of displacements, px over the exposure. The bound is twice the diagonal of the image if no pass
// has measured the longest displacement.
float reachPx() {
  if (params.limit >= 0.0) return limitPx();
#if HAS_max_displacement
  uint bits = max_displacement_buf.entries[0];  // floats of at least 0 have the order of their bits
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
