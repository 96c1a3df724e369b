// SPDX-License-Identifier: MIT
// Needs: edge_img; may have: where_tex.
// What every edge detector shares: where it looks and what it says. Where `where` is above 1/2 it looks; absent:
// everywhere.
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
