// SPDX-License-Identifier: MIT
// Edge detector: marks pixels where depth or normal changes abruptly, by gradients with Sobel's kernel (Sobel and Feldman 1968;
// in a ray mask: Tan, Cui, Bhojan 2020, "Ray Mask").
// In:  `depth`: view depth, metres; +inf for the sky.
//      `normal`: unit normal in world space; 0 for the sky.
//      `where`: mask, above 1/2 at the pixels to test (absent: all pixels are tested).
// Out: `edge`: 1 on an edge, otherwise 0. An edge is two pixels wide at a step, one pixel on each side.
// Method: the gradient along x is the convolution with the kernel 1/4 [1 2 1]^T [-1 0 1], and the gradient along y with its
//   transpose. A step of 1 has the response 1.
//   Depths are divided by the depth of the tested pixel, so that the scale of the scene has no effect. The quotient is at most
//   kFarthest (16), also for the sky. The three components of the normal count as one length; a step of the normal is at most
//   2. Pixels outside the image have the values of the nearest border pixel.
//   The depth gradient is divided by `depth_threshold`, the normal gradient by `normal_threshold`. The pixel is an edge if both
//   together exceed 1: the larger, the sum or the smaller of the two, by the parameter `combine`.
// Fails: also marks curved surfaces and planes at grazing angles, where the depth gradient is as large as at an edge. Pixels of
//   the sky are never marked, so that an edge against the sky is one pixel wide.
#include "mixin/edge_gradient.glsl"

void run(ivec2 pixel) { markEdge(pixel, isStepBy(pixel, 0.5, 0.25)); }
