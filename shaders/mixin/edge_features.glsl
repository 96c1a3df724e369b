// SPDX-License-Identifier: MIT
// Needs: depth_tex, normal_tex.
// Features that edge detectors compare between pixels: normals, and depths relative to the depth of one pixel.
#ifndef STROBE_EDGE_FEATURES_GLSL
#define STROBE_EDGE_FEATURES_GLSL
#include "mixin/edge_depth.glsl"

// Normal at a pixel; outside of the image, at the nearest border pixel.
vec3 normalAt(ivec2 pixel) {
  return finiteColor(texelFetch(normal_tex, clampToImage(pixel, textureSize(normal_tex, 0)), 0));
}

// Normal (unit, world; 0 for the sky) and depth of a pixel. The depth is a multiple of `depth`, so that no scale is built in.
vec4 featureAt(ivec2 pixel, float depth) {
  return vec4(normalAt(pixel), min(depthAt(pixel) / depth, kFarthest));
}

// Normal and inverse depth of a pixel. On a plane the inverse depth is affine in screen space; 0 for the sky.
vec4 inverseFeatureAt(ivec2 pixel, float depth) {
  return vec4(normalAt(pixel), min(depth / depthAt(pixel), kFarthest));
}

// Sum of the features at `offset` and at the opposite offset, minus twice the pixel's own: 0 on a plane. Also 0 if one of the
// neighbours is outside of the image.
vec4 secondDifference(ivec2 pixel, ivec2 offset, float depth) {
  ivec2 size = textureSize(depth_tex, 0);
  if (!isInside(pixel + offset, size) || !isInside(pixel - offset, size)) return vec4(0);
  return inverseFeatureAt(pixel + offset, depth) + inverseFeatureAt(pixel - offset, depth) -
         2.0 * vec4(normalAt(pixel), 1.0);
}

#endif
