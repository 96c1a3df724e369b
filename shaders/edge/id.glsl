// SPDX-License-Identifier: MIT
// Silhouettes between instances: pixels with a neighbour on another, farther instance.
// In:  `depth`: view depth, m; +inf for the sky
//      `id`:    instance + 1; 0 for the sky
//      `where`: above 1/2 where to test; absent: everywhere
// Out: `edge`:  1 on an edge: one pixel wide, on the nearer side
// Method: compare id and depth with the four neighbours. If the depths of two instances are equal, neither pixel is an edge.
// Fails: contacts and intersections of static parts are edges too. Self-occlusion of one instance is missed.
#include "mixin/edge.glsl"
#include "mixin/edge_id.glsl"

void run(ivec2 pixel) {
  bool edge = isWanted(pixel) && (isBeyond(pixel, ivec2(1, 0)) || isBeyond(pixel, ivec2(-1, 0)) ||
                                  isBeyond(pixel, ivec2(0, 1)) || isBeyond(pixel, ivec2(0, -1)));
  markEdge(pixel, edge);
}
