// SPDX-License-Identifier: MIT
// Needs: depth_tex, normal_tex, PARAM_measure, scene.
// How far a neighbour is from the plane a pixel lies on.
#ifndef STROBE_EDGE_PLANE_GLSL
#define STROBE_EDGE_PLANE_GLSL
#include "mixin/camera.glsl"
#include "mixin/edge_features.glsl"

// The point a pixel sees, relative to the camera's: depths are bounded by the pixel's own, so that the sky is a place.
vec3 pointAt(ivec2 pixel, float depth) {
  ivec2 inside = clampToImage(pixel, textureSize(depth_tex, 0));
  Ray ray = cameraRay(TIME_SLICE, samplePosition(inside));
  return (ray.origin - scene_cameras[TIME_SLICE].position) +
         ray.direction * min(depthAt(inside), kFarthest * depth);
}

// As a share of the pixel's own depth. `second_difference`: on a plane 1/z is affine in screen space, so 1/z of the
// neighbours on both sides adds up to twice the pixel's own. `distance`: from the neighbour's point to the plane that
// touches the surface at the pixel.
float planeBreak(ivec2 pixel, ivec2 offset, float depth) {
#if PARAM_measure == measure_distance
  return abs(dot(normalAt(pixel), pointAt(pixel + offset, depth) - pointAt(pixel, depth))) / depth;
#else
  return abs(secondDifference(pixel, offset, depth).w);
#endif
}

#endif
