// SPDX-License-Identifier: MIT
// Edges from gradients of depth and normal (Scharr 2000): as edge/sobel, with the weights across the gradient that make
// its length least dependent on direction.
// In:  depth (view depth, sky +inf), normal (unit, world; sky 0), where (> 1/2: look here; absent: everywhere).
// Out: edge, 1 on an edge: two pixels wide at a step.
// Kernel 1/16 [3 10 3]^T [-1 0 1]: a unit step responds 1; waves 0.6 % less along a diagonal than along an axis at 7 px
//   per wave. That holds where depth varies smoothly: a hard step along a diagonal responds 1.15 (Sobel 1.06).
// Fails: as edge/sobel.
#include "mixin/edge_gradient.glsl"

void run(ivec2 pixel) { markEdge(pixel, isStepBy(pixel, 0.625, 0.1875)); }
