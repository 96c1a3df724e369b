// SPDX-License-Identifier: MIT
// Edges where a surface leaves its own plane, and where its normal steps.
// In:  `depth`:  view depth, m; +inf for the sky
//      `normal`: unit, world; 0 for the sky
//      `where`:  above 1/2 where to test; absent: everywhere
// Out: `edge`:   1 on an edge: two pixels wide at a step
// Method: depth: the largest distance from the plane over the four neighbours (mixin/edge_plane.glsl). Normal: the largest
//      difference to a neighbour, for creases. Each is divided by its threshold; a pixel is an edge if the combination exceeds
//      1.
// Fails: a farther surface in the same plane is missed; quantised depths make edges. With second differences, pixels whose two
//      neighbours are as much nearer as farther (in 1/z) and the border of the image are missed. With distances, silhouettes of
//      curved surfaces are missed, where the plane runs along the view ray.
#include "mixin/edge.glsl"
#include "mixin/edge_plane.glsl"
#include "mixin/edge_steps.glsl"

float normalStep(ivec2 pixel, ivec2 offset) { return length(normalAt(pixel + offset) - normalAt(pixel)); }

void run(ivec2 pixel) {
  const ivec2 neighbours[4] = ivec2[](ivec2(1, 0), ivec2(0, 1), ivec2(-1, 0), ivec2(0, -1));
  float depth = depthAt(pixel);
  bool edge = false;
  if (isWanted(pixel) && isSurface(depth)) {
    float depth_step = 0.0, normal_step = 0.0;
    for (int i = 0; i < 4; ++i) {
      depth_step = max(depth_step, planeBreak(pixel, neighbours[i], depth));
      normal_step = max(normal_step, normalStep(pixel, neighbours[i]));
    }
    edge = combined(depth_step, normal_step) > 1.0;
  }
  markEdge(pixel, edge);
}
