// SPDX-License-Identifier: MIT
// Needs: depth_tex, normal_tex.
// Features that edge detectors compare between pixels: the normal, and the depth relative to the depth of the tested pixel.
// Relative depths do not depend on the scale of the scene. In all functions, `depth` is the view depth of the tested pixel,
// metres, finite and above 0.
#ifndef STROBE_EDGE_FEATURES_GLSL
#define STROBE_EDGE_FEATURES_GLSL
#include "mixin/edge_depth.glsl"

// Normal at a pixel: unit vector in world space; 0 for the sky. Outside of the image: normal at the nearest border pixel.
vec3 normalAt(ivec2 pixel) {
  return finiteColor(texelFetch(normal_tex, clampToImage(pixel, textureSize(normal_tex, 0)), 0));
}

// Feature for gradients. xyz: normal of a pixel. w: depth of the pixel divided by `depth`, at most kFarthest (also for the
// sky).
vec4 featureAt(ivec2 pixel, float depth) {
  return vec4(normalAt(pixel), min(depthAt(pixel) / depth, kFarthest));
}

// Feature for second differences. xyz: normal of a pixel. w: `depth` divided by the depth of the pixel, at most kFarthest; 0
// for the sky. On a plane, w is affine in screen space, so its second difference is 0.
vec4 inverseFeatureAt(ivec2 pixel, float depth) {
  return vec4(normalAt(pixel), min(depth / depthAt(pixel), kFarthest));
}

// Second difference of the features: the features at `offset` from the pixel, plus the features at the opposite offset, minus
// twice the features of the pixel. 0 on a plane. Also 0 if one of the two neighbours is outside of the image.
vec4 secondDifference(ivec2 pixel, ivec2 offset, float depth) {
  ivec2 size = textureSize(depth_tex, 0);
  if (!isInside(pixel + offset, size) || !isInside(pixel - offset, size)) return vec4(0);
  return inverseFeatureAt(pixel + offset, depth) + inverseFeatureAt(pixel - offset, depth) -
         2.0 * vec4(normalAt(pixel), 1.0);
}

#endif
