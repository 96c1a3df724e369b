// SPDX-License-Identifier: MIT
// Edge detector: marks the silhouettes of instances, that is, pixels with a neighbour on another, farther instance.
// In:  `depth`: view depth, metres; +inf for the sky.
//      `id`: instance + 1; 0 for the sky.
//      `where`: mask, above 1/2 at the pixels to test (absent: all pixels are tested).
// Out: `edge`: 1 on an edge, otherwise 0. An edge is one pixel wide and lies on the nearer instance.
// Method: compare id and depth of the pixel with its four neighbours. A neighbour with another id and a larger depth makes the
//   pixel an edge. If the depths of two instances are equal, neither pixel is an edge.
// Fails: also marks the lines along which static objects touch or intersect. Misses silhouettes of an instance in front of
//   itself.
#include "mixin/edge.glsl"
#include "mixin/edge_id.glsl"

void run(ivec2 pixel) {
  bool edge = isWanted(pixel) && (isBeyond(pixel, ivec2(1, 0)) || isBeyond(pixel, ivec2(-1, 0)) ||
                                  isBeyond(pixel, ivec2(0, 1)) || isBeyond(pixel, ivec2(0, -1)));
  markEdge(pixel, edge);
}
