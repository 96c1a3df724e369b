// SPDX-License-Identifier: MIT
// Edge mask: pixels beside a pixel that is farther by more than the depth threshold.
// In:  `depth`: linear view depth, metres; +inf for the sky.
//      `where`: above 1/2 where edges are detected; absent: everywhere.
// Out: `edge`: 1 on an edge, one pixel wide, on the nearer side.
// Method: a pixel is an edge if the depth of one of its four neighbours exceeds depth * (1 + depth_threshold).
// Fails: marks planes at grazing angles, where the next row of pixels is farther by more than the threshold.
#include "mixin/edge.glsl"
#include "mixin/edge_depth.glsl"

bool isStepTo(ivec2 neighbour, float depth) { return depthAt(neighbour) > depth * (1.0 + params.depth_threshold); }

void run(ivec2 pixel) {
  float depth = depthAt(pixel);
  bool edge = isStepTo(pixel + ivec2(1, 0), depth) || isStepTo(pixel - ivec2(1, 0), depth) ||
              isStepTo(pixel + ivec2(0, 1), depth) || isStepTo(pixel - ivec2(0, 1), depth);
  markEdge(pixel, edge && isWanted(pixel));
}
