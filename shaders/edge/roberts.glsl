// SPDX-License-Identifier: MIT
// Edges from differences of depth and normal along two diagonals (Roberts 1963).
// In:  `depth`:  view depth, m; +inf for the sky
//      `normal`: unit, world; 0 for the sky
//      `where`:  above 1/2 where to test; absent: everywhere
// Out: `edge`:   1 on an edge: one pixel wide at a step
// Method: differences along both diagonals of the pixel and its neighbours to the right and below, scaled so that the response
//      to a unit step along an axis is 1. The differences are centred on the common corner of the four pixels, half a pixel to
//      the right and below. A step is therefore marked on the pixel to its left or above it, whichever side is nearer. Depths
//      are relative to the pixel's own, as in edge/sobel.
// Fails: a silhouette whose nearer side is to the right or below is marked on the farther side, where a mask that reads the
//      nearer side misses it. Noise and planes at grazing angles are marked too.
#include "mixin/edge_gradient.glsl"

// A unit step along an axis changes both diagonal differences by 1: the l1 norm is 2, the l2 norm sqrt(2).
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
