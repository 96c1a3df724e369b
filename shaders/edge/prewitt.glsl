// SPDX-License-Identifier: MIT
// Edges from gradients of depth and normal (Prewitt 1970): as edge/sobel, with equal weights across the gradient.
// In:  depth (view depth, sky +inf), normal (unit, world; sky 0), where (> 1/2: look here; absent: everywhere).
// Out: edge, 1 on an edge: two pixels wide at a step.
// Kernel 1/3 [1 1 1]^T [-1 0 1]: a unit step responds 1, one along a diagonal .94, waves 6.7 % less along a diagonal
//   than along an axis at 7 px per wave.
// Fails: as edge/sobel, with more bias between directions.
#include "mixin/edge_gradient.glsl"

void run(ivec2 pixel) { markEdge(pixel, isStepBy(pixel, 1.0 / 3.0, 1.0 / 3.0)); }
