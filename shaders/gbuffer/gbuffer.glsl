// SPDX-License-Identifier: MIT
// Depth, normal, ids and displacement of the surface at each pixel, at this pass's time (its `time` in the pipeline).
// In:  `hit`: visible surface: instance + 1 (0 for the sky), geometry, primitive.
// Out: `depth`: view depth, metres; +inf for the sky; quantised (mixin/quantised.glsl).
//      `normal`: unit normal in world space, towards the camera; 0 for the sky.
//      `id`: instance + 1, geometry + 1; 0 for the sky.
//      `velocity`: displacement over the exposure, px; 0 if it is not finite; quantised (mixin/quantised.glsl).
// Method: pose the triangle of `hit` and intersect the pixel's ray with it. With `displacement` = window, the displacement is
//   the point's screen position at shutter close minus its position at shutter open. With `displacement` = extrapolated, it is
//   the position at the raster time minus the position in the previous frame, times the length of the exposure in frames.
// Fails: one displacement per pixel: a curved path within the exposure is treated as a straight line.
#include "mixin/quantised.glsl"
#include "mixin/surface.glsl"

void run(ivec2 pixel) {
  uvec4 ids = texelFetch(hit_tex, pixel, 0);
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  float depth = uintBitsToFloat(0x7f800000u);
  vec3 normal = vec3(0);
  uvec2 id = uvec2(0);
  vec2 velocity;
  if (ids.x == 0u) {
    velocity = displacementOfSky(ray.direction);
  } else {
    Hit hit = hitOnTriangle(TIME_SLICE, ray, ids.x - 1u, ids.y, ids.z);
    depth = hit.t;
    normal = surfaceOf(TIME_SLICE, hit).normal_ws;
    id = uvec2(ids.x, ids.y + 1u);
    bool at_raster_time = TIME_SLICE == SLICE_RASTER;
    velocity = displacementOf(hit, at_raster_time ? ray.origin + ray.direction * depth : positionOf(SLICE_RASTER, hit));
  }
#if PARAM_displacement == displacement_extrapolated
  if (frame.exposure > 1.0 && velocity != vec2(0)) count_stretched(1u);
#endif
  if (met_near_plane) count_near_plane(1u);
  if (any(isnan(velocity)) || any(isinf(velocity))) {
    count_not_finite(1u);
    velocity = vec2(0);
  }
  imageStore(depth_img, pixel, vec4(quantisedDepth(depth)));
  imageStore(normal_img, pixel, vec4(normal, 0));
  imageStore(id_img, pixel, uvec4(id, 0u, 0u));
  imageStore(velocity_img, pixel, vec4(quantisedVelocity(velocity), 0, 0));
}
