// SPDX-License-Identifier: MIT
// Needs: depth_tex, edge_img, normal_tex, params.depth_threshold, params.normal_threshold, PARAM_combine, PARAM_norm,
//   where_tex.
// Edge test by the gradients of depth and normal, with kernels of 3x3 pixels. A kernel is scaled so that its response to a step
// of 1 along an axis is 1.
#ifndef STROBE_EDGE_GRADIENT_GLSL
#define STROBE_EDGE_GRADIENT_GLSL
#include "mixin/edge.glsl"
#include "mixin/edge_features.glsl"
#include "mixin/edge_steps.glsl"

// Length of the vector (a, b). The parameter `norm` chooses the sum of the magnitudes (`l1`) or the Euclidean length.
float sizeOf(float a, float b) {
#if PARAM_norm == norm_l1
  return abs(a) + abs(b);
#else
  return length(vec2(a, b));
#endif
}

// True if the strength of an edge exceeds 1. The strength combines the gradients of depth and normal, each divided by
// its threshold; the parameter `combine` chooses how (mixin/edge_steps.glsl). `a`, `b`: the gradients, as differences
// of the features (xyz normal, w depth) in two perpendicular directions. The normal's difference in one direction is
// the length of its three components.
bool isStep(vec4 a, vec4 b) {
  return combined(sizeOf(a.w, b.w), sizeOf(length(vec3(a)), length(vec3(b)))) > 1.0;
}

// Response of a kernel along one axis: the weighted sum of three pixels ahead of the pixel minus the weighted sum of three
// pixels behind it. `along`: step ahead. `across`: step to the side. `middle`, `side`: weights of the middle pixel and of both
// side pixels. `depth`: view depth of the pixel, metres.
vec4 difference(ivec2 pixel, ivec2 along, ivec2 across, float depth, float middle, float side) {
  vec4 ahead = side * featureAt(pixel + along - across, depth) + middle * featureAt(pixel + along, depth) +
               side * featureAt(pixel + along + across, depth);
  vec4 opposite = side * featureAt(pixel - along - across, depth) + middle * featureAt(pixel - along, depth) +
                  side * featureAt(pixel - along + across, depth);
  return ahead - opposite;
}

// True if the pixel is on an edge, by the gradient in x and in y. The kernel is [side middle side]^T [-1 0 1] in x and its
// transpose in y, with 2 * side + middle = 1.
bool isStepBy(ivec2 pixel, float middle, float side) {
  float depth = depthAt(pixel);
  if (!isWanted(pixel) || !isSurface(depth)) return false;
  vec4 in_x = difference(pixel, ivec2(1, 0), ivec2(0, 1), depth, middle, side);
  vec4 in_y = difference(pixel, ivec2(0, 1), ivec2(1, 0), depth, middle, side);
  return isStep(in_x, in_y);
}

#endif
