// SPDX-License-Identifier: MIT
// Needs: depth_tex, normal_tex, PARAM_measure, scene.
// Deviation of a neighbouring pixel's surface from the plane of the pixel's surface.
#ifndef STROBE_EDGE_PLANE_GLSL
#define STROBE_EDGE_PLANE_GLSL
#include "mixin/camera.glsl"
#include "mixin/edge_features.glsl"

// Surface point at a pixel, relative to the camera. The point's depth is at most kFarthest times `depth`, so that the sky has a
// finite position.
vec3 pointAt(ivec2 pixel, float depth) {
  ivec2 inside = clampToImage(pixel, textureSize(depth_tex, 0));
  Ray ray = cameraRay(TIME_SLICE, samplePosition(inside));
  return (ray.origin - scene_cameras[TIME_SLICE].position) +
         ray.direction * min(depthAt(inside), kFarthest * depth);
}

// Deviation of the neighbour from the pixel's plane, as a share of the pixel's depth, by one of two measures.
// second_difference: on a plane 1/z is affine in screen space, so 1/z of the neighbours on both sides adds up to twice 1/z of
// the pixel. The deviation is the difference of both.
// distance: the deviation is the distance of the neighbour's point from the plane that touches the surface at the pixel.
float planeBreak(ivec2 pixel, ivec2 offset, float depth) {
#if PARAM_measure == measure_distance
  return abs(dot(normalAt(pixel), pointAt(pixel + offset, depth) - pointAt(pixel, depth))) / depth;
#else
  return abs(secondDifference(pixel, offset, depth).w);
#endif
}

#endif
