// SPDX-License-Identifier: MIT
// Edges where the depth of a neighbour exceeds the depth of the pixel by the threshold.
// In:  `depth`: linear view depth, metres; +inf for the sky.
//      `where`: above 1/2 where edges are detected; absent: everywhere.
// Out: `edge`: 1 on an edge, one pixel wide, on the nearer side.
// Method: compare the depth with the depths of the four neighbours.
// Fails: marks planes at grazing angles.
#include "mixin/edge.glsl"
#include "mixin/edge_depth.glsl"

bool isStepTo(ivec2 neighbour, float depth) { return depthAt(neighbour) > depth * (1.0 + params.depth_threshold); }

void run(ivec2 pixel) {
  float depth = depthAt(pixel);
  bool edge = isStepTo(pixel + ivec2(1, 0), depth) || isStepTo(pixel - ivec2(1, 0), depth) ||
              isStepTo(pixel + ivec2(0, 1), depth) || isStepTo(pixel - ivec2(0, 1), depth);
  markEdge(pixel, edge && isWanted(pixel));
}
