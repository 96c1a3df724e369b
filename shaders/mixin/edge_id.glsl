// SPDX-License-Identifier: MIT
// Needs: depth_tex, id_tex.
// Silhouette test between instances. Ids: instance + 1; 0 for the sky.
#ifndef STROBE_EDGE_ID_GLSL
#define STROBE_EDGE_ID_GLSL
#include "mixin/edge_depth.glsl"

// True if the neighbour at `offset` shows another instance, farther than the pixel's. At equal depths the test is false for
// both pixels.
bool isBeyond(ivec2 pixel, ivec2 offset) {
  ivec2 at = clampToImage(pixel + offset, textureSize(id_tex, 0));
  if (texelFetch(id_tex, at, 0).x == texelFetch(id_tex, pixel, 0).x) return false;
  return depthAt(at) > depthAt(pixel);
}

#endif
