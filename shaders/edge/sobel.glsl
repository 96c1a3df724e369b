// SPDX-License-Identifier: MIT
// Edges from gradients of depth and normal (Tan, Cui, Bhojan 2020, Ray Mask; Sobel and Feldman 1968).
// In:  depth (view depth, sky +inf), normal (unit, world; sky 0), where (> 1/2: look here; absent: everywhere).
// Out: edge, 1 on an edge: two pixels wide at a step.
// Kernel 1/4 [1 2 1]^T [-1 0 1]: a unit step responds 1. The depth gradient is divided by the pixel's own depth, so
//   that no scale is built in; depths beyond kFarthest times that count as kFarthest times it, sky among them. The
//   normal gradient is that of all three components; the largest step is 2. Each is divided by its threshold; an edge
//   is where the combination (the larger, the sum, or the smaller of both) exceeds 1. Outside of the picture its
//   border goes on.
// Fails: planes at grazing angles (the depth gradient grows with 1/cos); curved surfaces; sky has no edge of its own.
#include "mixin/edge_gradient.glsl"

void run(ivec2 pixel) { markEdge(pixel, isStepBy(pixel, 0.5, 0.25)); }
