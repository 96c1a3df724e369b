// SPDX-License-Identifier: MIT
// Needs: params.limit; may have: max_displacement_buf, max_displacement_post_buf, revealed_max_displacement_buf,
//   revealed_max_displacement_post_buf.
// Bounds of displacements in filters, from the parameter `limit`: the longest displacement that a filter handles, in image
// widths. The filter shortens longer displacements to the limit, and searches for surfaces within this distance. With `limit` =
// auto, stored as a negative number, no displacement is shortened, and the search distance is the longest displacement in the
// image.
#ifndef STROBE_LIMIT_GLSL
#define STROBE_LIMIT_GLSL
#include "lib/blur.glsl"

const float kNoLimit = 1e18;   // limitPx with `limit` = auto, px; its square is finite
const float kMostReach = 1e6;  // largest reachPx with `limit` = auto, px; the number of tiles on any path then fits an integer

// Largest length of a displacement, px over the exposure. Filters shorten longer displacements to this length.
float limitPx() { return params.limit < 0.0 ? kNoLimit : params.limit * float(frame.size.x); }

// Upper bound of the lengths of the displacements that a filter uses, px over the exposure. With `limit` = auto it is the
// longest displacement in the image (`max_displacement`), or twice the diagonal of the image if the pass does not read that
// value.
float reachPx() {
  if (params.limit >= 0.0) return limitPx();
#if HAS_max_displacement
  uint bits = max_displacement_buf.entries[0];  // comparable as integers: floats of at least 0 have the order of their bits
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
