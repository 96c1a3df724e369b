// SPDX-License-Identifier: MIT
// Edges from gradients of depth and normal (Scharr 2000): the method of edge/sobel, with weights across the gradient that make
// the response least dependent on direction.
// In:  `depth`:  view depth, m; +inf for the sky
//      `normal`: unit, world; 0 for the sky
//      `where`:  above 1/2 where to test; absent: everywhere
// Out: `edge`:   1 on an edge: two pixels wide at a step
// Method: kernel 1/16 [3 10 3]^T [-1 0 1]. The response to a unit step is 1. The response to waves of 7 px is 0.6 % less along
//      a diagonal than along an axis.
// Fails: like edge/sobel. The equal response holds for smooth depth only: the response to a hard step along a diagonal is 1.15
//      (Sobel 1.06).
#include "mixin/edge_gradient.glsl"

void run(ivec2 pixel) { markEdge(pixel, isStepBy(pixel, 0.625, 0.1875)); }
