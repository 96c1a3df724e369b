// SPDX-License-Identifier: MIT
// Adds one time sample of the moving surfaces to their running mean at each pixel (Haeberli and Akeley 1990, "The Accumulation
// Buffer"). The pass runs once per time sample, in a loop.
// In:  `hit`: nearest surface at this time; with a static camera, nearest moving surface. Instance + 1 (0 for the sky),
//        geometry, primitive.
//      `color`: linear radiance of the raster layer.
//      `depth`: view depth of the raster layer, metres; +inf for the sky.
//      `id`: instance + 1, geometry + 1 of the raster layer; 0 for the sky.
//      `static_background`: alpha: view depth of the static background behind a moving surface of the raster layer, metres; 0
//        elsewhere.
// Out: `moving`: updated in place. rgb: mean linear radiance of the samples that show a moving surface; alpha: number of these
//        samples.
// Method: pose the triangle of `hit` at this time and intersect the pixel's ray with it. If the raster layer shows the hit
//   point, take that layer's colour (mixin/raster_color.glsl); otherwise shade the point as at the raster time. With a static
//   camera, skip static surfaces and the moving surfaces behind them, because `over_background` adds the static radiance. With
//   a moving camera, every surface and the sky count as moving.
// Fails: highlights and shadows do not move within the exposure, because points are shaded as at the raster time.
#include "lib/mean.glsl"
#include "lib/moving_rect.glsl"
#include "mixin/raster_color.glsl"

// Colour of the hit point, as at the raster time. With `reused`, take the colour of the raster layer if that layer
// shows the point (mixin/raster_color.glsl). Otherwise shade the point.
vec3 colorOf(Hit hit) {
#if PARAM_reused
  return rasterColorOf(hit);
#else
  count_shaded(1u);
  return shade(SLICE_RASTER, hit);
#endif
}

// View depth of the nearest static surface on the pixel's ray, metres, for a static camera.
float backgroundDepthOf(ivec2 pixel) {
  float background = texelFetch(static_background_tex, pixel, 0).a;
  return background > 0.0 ? background : texelFetch(depth_tex, pixel, 0).x;
}

void run(ivec2 pixel) {
#if PARAM_skip_static
  if (!isInMovingRect(pixel)) return;
#endif
  bool camera_rests = frame.camera_rests != 0u;
  uvec4 ids = texelFetch(hit_tex, pixel, 0);
  if (camera_rests && (ids.x == 0u || instanceAt(ids.x - 1u).moves == 0u)) return;
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  Hit hit = noHit();
  if (ids.x != 0u) hit = hitOnTriangle(TIME_SLICE, ray, ids.x - 1u, ids.y, ids.z);
  if (camera_rests && !(hit.t < backgroundDepthOf(pixel))) return;
  vec3 color = isHit(hit) ? colorOf(hit) : environment(ray.direction);
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(moving_img, pixel, withSample(imageLoad(moving_img, pixel), color));
}
