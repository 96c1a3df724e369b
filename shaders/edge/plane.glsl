// SPDX-License-Identifier: MIT
// Edges where a surface leaves the plane it is on, and where its normal steps.
// In:  depth (view depth, sky +inf), normal (unit, world; sky 0), where (> 1/2: look here; absent: everywhere).
// Out: edge, 1 on an edge: two pixels wide at a step.
// Depth: the larger of both axes; see mixin/edge_plane.glsl. Normal: the longest difference to one of four neighbours,
//   for creases. Each is divided by its threshold; an edge is where the combination exceeds 1.
// Fails: a farther surface that lies on the same plane; quantised depth; by second differences, pixels whose two
//   neighbours lie as much before as behind them (in 1/z), and the picture's border; by distance, the silhouettes of
//   curved surfaces, where the plane runs along the line of sight.
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
