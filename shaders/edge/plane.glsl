// SPDX-License-Identifier: MIT
// Edges where a surface leaves its own plane, and where its normal steps.
// In:  `depth`:  view depth, m; +inf for the sky
//      `normal`: unit, world; 0 for the sky
//      `where`:  above 1/2 where to test; absent: everywhere
// Out: `edge`:   1 on an edge: two pixels wide at a step
// Method: the depth step is the largest distance of the four neighbours from the pixel's plane (mixin/edge_plane.glsl). The
//      normal step, for creases, is the largest difference to the normal of a neighbour. Each step is divided by its threshold.
//      A pixel is an edge if the combination of both exceeds 1.
// Fails: a farther surface in the same plane is missed. Quantised depths make edges. With second differences, two places are
//      missed: pixels with one neighbour as much nearer as the other is farther (in 1/z), and the border of the image. With
//      distances, silhouettes of curved surfaces are missed, where the plane runs along the view ray.
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
