// SPDX-License-Identifier: MIT
// Edge detector: marks pixels where depth or normal changes abruptly, by differences along two diagonals (Roberts 1963).
// In:  `depth`: view depth, metres; +inf for the sky.
//      `normal`: unit normal in world space; 0 for the sky.
//      `where`: mask, above 1/2 at the pixels to test (absent: all pixels are tested).
// Out: `edge`: 1 on an edge, otherwise 0. An edge is one pixel wide at a step.
// Method: in the block of 2x2 pixels that begins at the pixel and extends to the right and down, take the differences along
//   both diagonals, scaled so that a step along an axis has the response 1. Depths are divided by the depth of the pixel. A
//   pixel is an edge if its differences of depth and normal, each divided by its threshold, together exceed 1 (parameter
//   `combine`).
//   The differences are centred on the middle of the block, half a pixel to the right of and below the pixel. A step is
//   therefore marked on the pixel to its left or above it, on the nearer or the farther side.
// Fails: if the nearer surface is to the right or below, the silhouette is marked on the farther surface. A ray mask
//   searches for edges on the nearer surface, and misses such an edge. Also marks noise and planes at grazing angles.
#include "mixin/edge_gradient.glsl"

// Scale of the diagonal differences. A step of 1 along an axis changes both differences by 1, so that their l1 norm is 2 and
// their l2 norm sqrt(2). The scale makes this response 1.
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
