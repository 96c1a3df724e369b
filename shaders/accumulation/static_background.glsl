// SPDX-License-Identifier: MIT
// Static background behind the moving surfaces of the raster layer, for a static camera. Time samples without a moving surface
// show this background.
// In:  `hit`: raster layer: instance + 1 (0 for the sky), geometry, primitive.
// Out: `static_background`: rgb: linear radiance; alpha: view depth, metres, +inf for the sky; 0 where the raster layer is
//        static.
// Method: in each pixel of the moving rectangle that shows a moving instance, trace rays from hit to hit until a ray hits a
//   static surface or leaves the scene. Each ray skips the whole instance of the last hit. Shade the static hit as at the
//   raster time.
// Fails: static surfaces keep the shadows of the raster time. A static surface that coincides with the second or a later moving
//   surface on the ray is missed.
#include "lib/moving_rect.glsl"
#include "mixin/shade.glsl"

// True if a hit of the raster layer is on an instance that may move within the exposure.
bool isMoving(uvec4 ids) { return ids.x != 0u && instanceAt(ids.x - 1u).moves != 0u; }

// Nearest static surface along the ray, or a miss. `first_moving`: instance of the visible moving surface. Each further ray
// starts at the last hit, which is moving, and skips the whole instance of that hit.
Hit staticHitOn(Ray ray, uint first_moving) {
  Hit hit = traceExcept(SLICE_RASTER, RAYS_TO_ALL, ray, scene_cameras[SLICE_RASTER].near, 3.0e38, first_moving, NO_INSTANCE);
  while (!isAtRest(hit))
    hit = traceExcept(SLICE_RASTER, RAYS_TO_ALL, ray, hit.t, 3.0e38, hit.instance, NO_INSTANCE);
  return hit;
}

void run(ivec2 pixel) {
  if (frame.camera_rests == 0u || !isInMovingRect(pixel)) return;
  uvec4 ids = texelFetch(hit_tex, pixel, 0);
  if (!isMoving(ids)) return;
  count_rays(1u);
  Ray ray = cameraRay(SLICE_RASTER, samplePosition(pixel));
  Hit hit = staticHitOn(ray, ids.x - 1u);
  vec4 static_background = vec4(0, 0, 0, uintBitsToFloat(0x7f800000u));
  if (isHit(hit)) {
    hit = hitOnTriangle(SLICE_RASTER, ray, hit.instance, hit.geometry, hit.primitive);
    static_background = vec4(shade(SLICE_RASTER, hit), hit.t);
  } else {
    static_background.rgb = environment(ray.direction);
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(static_background_img, pixel, static_background);
}
