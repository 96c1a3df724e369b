// SPDX-License-Identifier: MIT
// Silhouettes between instances: a pixel is an edge if one of its four neighbours is another instance and farther.
// In:  depth (view depth, sky +inf), id (instance + 1, 0 = sky), where (> 1/2: look here; absent: everywhere).
// Out: edge, 1 on an edge: one pixel wide, on the nearer side. Of equal depths neither is an edge.
// Fails: contacts and intersections of resting parts are edges too; blind to self-occlusion of one instance.
#include "mixin/edge.glsl"
#include "mixin/edge_id.glsl"

void run(ivec2 pixel) {
  bool edge = isWanted(pixel) && (isBeyond(pixel, ivec2(1, 0)) || isBeyond(pixel, ivec2(-1, 0)) ||
                                  isBeyond(pixel, ivec2(0, 1)) || isBeyond(pixel, ivec2(0, -1)));
  markEdge(pixel, edge);
}
