// SPDX-License-Identifier: MIT
// Needs: depth_tex, id_tex.
// The silhouette test between instances. An id is instance + 1, 0 = sky.
#ifndef STROBE_EDGE_ID_GLSL
#define STROBE_EDGE_ID_GLSL
#include "mixin/edge_depth.glsl"

// Is the neighbour at `offset` another instance, and farther? Of equal depths neither is.
bool isBeyond(ivec2 pixel, ivec2 offset) {
  ivec2 at = clampToImage(pixel + offset, textureSize(id_tex, 0));
  if (texelFetch(id_tex, at, 0).x == texelFetch(id_tex, pixel, 0).x) return false;
  return depthAt(at) > depthAt(pixel);
}

#endif
