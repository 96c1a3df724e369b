// SPDX-License-Identifier: MIT
// Needs: depth_tex, id_tex.
// Silhouette test between instances, by ids and depths. An id is the instance + 1, or 0 for the sky.
#ifndef STROBE_EDGE_ID_GLSL
#define STROBE_EDGE_ID_GLSL
#include "mixin/edge_depth.glsl"

// True if the neighbour at `offset` shows another instance (or the sky) that is farther than the pixel's surface. Of two
// adjacent pixels, the test is true only for the nearer one. If both depths are equal, it is false for both pixels.
bool isBeyond(ivec2 pixel, ivec2 offset) {
  ivec2 at = clampToImage(pixel + offset, textureSize(id_tex, 0));
  if (texelFetch(id_tex, at, 0).x == texelFetch(id_tex, pixel, 0).x) return false;
  return depthAt(at) > depthAt(pixel);
}

#endif
