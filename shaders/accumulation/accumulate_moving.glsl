// SPDX-License-Identifier: MIT
// Adds the radiance of one time of the loop to each pixel's mean over moving surfaces (Haeberli and Akeley 1990).
// In:  `hit`:    nearest surface at this time; for a static camera the nearest moving surface
//      `color`:  linear radiance at the raster time
//      `depth`:  view depth at the raster time, m; +inf for the sky
//      `id`:     instance + 1, geometry + 1 at the raster time; 0 for the sky
//      `static_background`: alpha: view depth of the static background behind a moving surface, m; 0 elsewhere
// Out: `moving`: updated; rgb: mean linear radiance of the samples; alpha: their number
// Method: pose the triangle of `hit` at this time and intersect the pixel's ray with it. Take the colour of the raster layer if
//      it shows the point (mixin/raster_color.glsl); otherwise shade the point as at the raster time. For a static camera,
//      skip static surfaces and moving surfaces behind them: `over_background` adds the static radiance.
// Fails: highlights and shadows do not move within the exposure, because points are shaded as at the raster time.
#include "lib/mean.glsl"
#include "lib/moving_rect.glsl"
#include "mixin/raster_color.glsl"

vec3 colorOf(Hit hit) {
#if PARAM_reused
  return rasterColorOf(hit);
#else
  count_shaded(1u);
  return shade(SLICE_RASTER, hit);
#endif
}

// View depth of the nearest static surface on the pixel's ray, for a static camera.
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
