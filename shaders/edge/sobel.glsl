// SPDX-License-Identifier: MIT
// Edges from gradients of depth and normal (Tan, Cui, Bhojan 2020, "Ray Mask"; Sobel and Feldman 1968).
// In:  `depth`:  view depth, m; +inf for the sky
//      `normal`: unit, world; 0 for the sky
//      `where`:  above 1/2 where to test; absent: everywhere
// Out: `edge`:   1 on an edge: two pixels wide at a step
// Method: kernel 1/4 [1 2 1]^T [-1 0 1]. The response to a unit step is 1. The depth gradient is divided by the pixel's own
//      depth, which makes it independent of scale. Depths beyond kFarthest times the pixel's own depth, the sky included, count
//      as kFarthest times this depth. The normal gradient is the length over all three components; its largest step is 2. Each
//      gradient is divided by its threshold. A pixel is an edge if the combination of both (larger, sum or smaller) exceeds 1.
//      Outside the image the border repeats.
// Fails: planes at grazing angles (the depth gradient grows with 1/cos) and curved surfaces are marked. The sky has no edge of
//      its own.
#include "mixin/edge_gradient.glsl"

void run(ivec2 pixel) { markEdge(pixel, isStepBy(pixel, 0.5, 0.25)); }
