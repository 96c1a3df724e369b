// SPDX-License-Identifier: MIT
// What every edge detector shares: where it looks and what it says. For passes that write edge and may read where
// (> 1/2: look here; absent: everywhere).
#ifndef STROBE_EDGE_GLSL
#define STROBE_EDGE_GLSL

bool isWanted(ivec2 pixel) {
#if HAS_where
  return texelFetch(where_tex, pixel, 0).x > 0.5;
#else
  return true;
#endif
}

void markEdge(ivec2 pixel, bool edge) { imageStore(edge_img, pixel, vec4(edge ? 1 : 0)); }

#endif
