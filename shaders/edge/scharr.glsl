// SPDX-License-Identifier: MIT
// Edge detector: marks pixels where depth or normal changes abruptly, by gradients with Scharr's kernel (Scharr 2000). For
// smooth changes, the response depends less on the direction than with the kernels of edge/sobel.glsl and edge/prewitt.glsl.
// The rest of the method is described in edge/sobel.glsl.
// In:  `depth`: view depth, metres; +inf for the sky.
//      `normal`: unit normal in world space; 0 for the sky.
//      `where`: mask, above 1/2 at the pixels to test (absent: all pixels are tested).
// Out: `edge`: 1 on an edge, otherwise 0. An edge is two pixels wide at a step, one pixel on each side.
// Method: the gradient along x is the convolution with the kernel 1/16 [3 10 3]^T [-1 0 1], and the gradient along y with its
//   transpose. A pixel is an edge if its gradients of depth and normal, each divided by its threshold, together exceed 1
//   (parameter `combine`).
//   Response to a step along an axis: 1. Response to depths that vary as a sine wave with a wavelength of 7 px: 0.6 % less
//   along a diagonal than along an axis.
// Fails: also marks curved surfaces and planes at grazing angles, as all gradient detectors do. Only smooth changes have nearly
//   equal responses in all directions: a hard step along a diagonal has the response 1.15 (1.06 with Sobel's kernel).
#include "mixin/edge_gradient.glsl"

void run(ivec2 pixel) { markEdge(pixel, isStepBy(pixel, 0.625, 0.1875)); }
