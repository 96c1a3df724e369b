// SPDX-License-Identifier: MIT
// Needs: depth_tex, normal_tex.
// What edge detectors compare between pixels: normals, and depths relative to one.
#ifndef STROBE_EDGE_FEATURES_GLSL
#define STROBE_EDGE_FEATURES_GLSL
#include "mixin/edge_depth.glsl"

vec3 normalAt(ivec2 pixel) {
  return finiteColor(texelFetch(normal_tex, clampToImage(pixel, textureSize(normal_tex, 0)), 0));
}

// Normal (unit, world; sky 0) and depth of a pixel; the depth as a multiple of `depth`, so that no scale is built in.
vec4 featureAt(ivec2 pixel, float depth) {
  return vec4(normalAt(pixel), min(depthAt(pixel) / depth, kFarthest));
}

// The same with the inverse of the depth, which is affine in screen space on a plane; 0 for the sky.
vec4 inverseFeatureAt(ivec2 pixel, float depth) {
  return vec4(normalAt(pixel), min(depth / depthAt(pixel), kFarthest));
}

// Sum of the neighbours at `offset` and opposite, less twice the pixel itself: 0 on a plane. A line that leaves the
// picture says nothing.
vec4 secondDifference(ivec2 pixel, ivec2 offset, float depth) {
  ivec2 size = textureSize(depth_tex, 0);
  if (!isInside(pixel + offset, size) || !isInside(pixel - offset, size)) return vec4(0);
  return inverseFeatureAt(pixel + offset, depth) + inverseFeatureAt(pixel - offset, depth) -
         2.0 * vec4(normalAt(pixel), 1.0);
}

#endif
