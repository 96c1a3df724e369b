// SPDX-License-Identifier: MIT
// Edges from gradients of depth and normal (Prewitt 1970): the method of edge/sobel, with equal weights across the gradient.
// In:  `depth`:  view depth, m; +inf for the sky
//      `normal`: unit, world; 0 for the sky
//      `where`:  above 1/2 where to test; absent: everywhere
// Out: `edge`:   1 on an edge: two pixels wide at a step
// Method: kernel 1/3 [1 1 1]^T [-1 0 1]. The response is 1 to a unit step, and 0.94 to a step along a diagonal. The response to
//      waves of 7 px is 6.7 % less along a diagonal than along an axis.
// Fails: like edge/sobel, and the response depends more on the direction.
#include "mixin/edge_gradient.glsl"

void run(ivec2 pixel) { markEdge(pixel, isStepBy(pixel, 1.0 / 3.0, 1.0 / 3.0)); }
