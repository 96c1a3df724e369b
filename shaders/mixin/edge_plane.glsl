// SPDX-License-Identifier: MIT
// Needs: depth_tex, normal_tex, PARAM_measure, scene.
// Test if two adjacent pixels show one plane: the deviation of the neighbour's surface from the plane of the pixel's surface.
#ifndef STROBE_EDGE_PLANE_GLSL
#define STROBE_EDGE_PLANE_GLSL
#include "mixin/camera.glsl"
#include "mixin/edge_features.glsl"

// Surface point at a pixel, relative to the camera, world axes, metres. The view depth of the point is at most kFarthest *
// `depth`, so that the sky has a finite position. `depth`: view depth of the tested pixel, metres.
vec3 pointAt(ivec2 pixel, float depth) {
  ivec2 inside = clampToImage(pixel, textureSize(depth_tex, 0));
  Ray ray = cameraRay(TIME_SLICE, samplePosition(inside));
  return (ray.origin - scene_cameras[TIME_SLICE].position) +
         ray.direction * min(depthAt(inside), kFarthest * depth);
}

// Deviation of the neighbour at `offset` from the pixel's plane, at least 0; 0 on a plane. `depth`: view depth of the pixel,
// metres. The parameter `measure` chooses one of two measures.
// second_difference: |depth/z1 + depth/z2 - 2|, with the depths z1 and z2 of the neighbour and of the pixel on the opposite
// side. On a plane 1/z is affine in screen space, so the sum is 2. The result is 0 if one of the two pixels is outside of the
// image.
// distance: distance of the neighbour's point from the plane that touches the surface at the pixel, divided by `depth`.
float planeBreak(ivec2 pixel, ivec2 offset, float depth) {
#if PARAM_measure == measure_distance
  return abs(dot(normalAt(pixel), pointAt(pixel + offset, depth) - pointAt(pixel, depth))) / depth;
#else
  return abs(secondDifference(pixel, offset, depth).w);
#endif
}

#endif
