// SPDX-License-Identifier: MIT
// The silhouette test between instances. For edge detectors that read id (instance + 1, 0 = sky).
#ifndef STROBE_EDGE_ID_GLSL
#define STROBE_EDGE_ID_GLSL
#include "lib/edge_depth.glsl"

// Is the neighbour at `offset` another instance, and farther? Of equal depths neither is.
bool isBeyond(ivec2 pixel, ivec2 offset) {
  ivec2 at = clampToImage(pixel + offset, textureSize(id_tex, 0));
  if (texelFetch(id_tex, at, 0).x == texelFetch(id_tex, pixel, 0).x) return false;
  return depthAt(at) > depthAt(pixel);
}

#endif
