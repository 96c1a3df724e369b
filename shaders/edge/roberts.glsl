// SPDX-License-Identifier: MIT
// Edges from gradients of depth and normal over two diagonals (Roberts 1963).
// In:  depth (view depth, sky +inf), normal (unit, world; sky 0), where (> 1/2: look here; absent: everywhere).
// Out: edge, 1 on an edge: one pixel wide at a step.
// The differences along both diagonals of the pixel and its neighbours to the right and below, scaled so that a unit
//   step along an axis responds 1. What it answers for is their common corner, half a pixel to the right and below:
//   a step is marked on the pixel to its left, or above it, whichever side is nearer. Depths as in edge/sobel.
// Fails: silhouettes whose nearer side is right or below are marked on what is farther, and lost to a mask that looks
//   on the nearer side only; noise; planes at grazing angles.
#include "mixin/edge_gradient.glsl"

#if PARAM_norm == norm_l1
const float kUnitStep = 0.5;
#else
const float kUnitStep = 0.70710678;
#endif

void run(ivec2 pixel) {
  float depth = depthAt(pixel);
  bool edge = false;
  if (isWanted(pixel) && isSurface(depth)) {
    vec4 down = featureAt(pixel + ivec2(1, 1), depth) - featureAt(pixel, depth);
    vec4 up = featureAt(pixel + ivec2(1, 0), depth) - featureAt(pixel + ivec2(0, 1), depth);
    edge = isStep(kUnitStep * down, kUnitStep * up);
  }
  markEdge(pixel, edge);
}
