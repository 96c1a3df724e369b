// SPDX-License-Identifier: MIT
// Edges from gradients of depth and normal (Prewitt 1970): as edge/sobel, with equal weights across the gradient.
// In:  `depth`:  view depth, m; +inf for the sky
//      `normal`: unit, world; 0 for the sky
//      `where`:  above 1/2 where to test; absent: everywhere
// Out: `edge`:   1 on an edge: two pixels wide at a step
// Method: kernel 1/3 [1 1 1]^T [-1 0 1]: a unit step responds 1, a step along a diagonal 0.94. Waves of 7 px respond 6.7 % less
//      along a diagonal than along an axis.
// Fails: as edge/sobel, with more dependence on direction.
#include "mixin/edge_gradient.glsl"

void run(ivec2 pixel) { markEdge(pixel, isStepBy(pixel, 1.0 / 3.0, 1.0 / 3.0)); }
