// SPDX-License-Identifier: MIT
// Edge detector: marks pixels where depth or normal changes abruptly, by gradients with Prewitt's kernel (Prewitt 1970). The
// kernel has equal weights across the gradient; the rest of the method is described in edge/sobel.glsl.
// In:  `depth`: view depth, metres; +inf for the sky.
//      `normal`: unit normal in world space; 0 for the sky.
//      `where`: mask, above 1/2 at the pixels to test (absent: all pixels are tested).
// Out: `edge`: 1 on an edge, otherwise 0. An edge is two pixels wide at a step, one pixel on each side.
// Method: the gradient along x is the convolution with the kernel 1/3 [1 1 1]^T [-1 0 1], and the gradient along y with its
//   transpose. A pixel is an edge if its gradients of depth and normal, each divided by its threshold, together exceed 1
//   (parameter `combine`).
//   Response to a step: 1 along an axis, 0.94 along a diagonal. Response to depths that vary as a sine wave with a wavelength
//   of 7 px: 6.7 % less along a diagonal than along an axis.
// Fails: also marks curved surfaces and planes at grazing angles, as all gradient detectors do. For waves, the response depends
//   on the direction more than with Sobel's kernel.
#include "mixin/edge_gradient.glsl"

void run(ivec2 pixel) { markEdge(pixel, isStepBy(pixel, 1.0 / 3.0, 1.0 / 3.0)); }
