// SPDX-License-Identifier: MIT
// Linear radiance of the surface at each pixel, with traced shadows.
// In:  `hit`: visible surface: instance + 1 (0 for the sky), geometry, primitive.
//      `light_visibility`: output of the pass `tile_light_visibility`, one bit per light for each tile of `shadow_tile` px. x:
//        the light is visible from the whole tile; y: the light is blocked from the whole tile (absent: all shadow rays are
//        traced).
// Out: `color`: linear radiance, alpha 1; quantised (mixin/quantised.glsl).
// Method: intersect the pixel's ray with the triangle at this pass's time (its `time` in the pipeline). Shade the point
//   (mixin/shade.glsl) in its pose at the raster time (`shading` = frozen) or at this pass's time (full). Lights with a bit in
//   `light_visibility` need no shadow ray.
// Fails: with frozen shading, lights, shadows and highlights do not move within the exposure.
#if HAS_light_visibility
#define STROBE_KEEPS_SHADOWS
#endif
#include "mixin/shade.glsl"
#include "mixin/quantised.glsl"

void run(ivec2 pixel) {
  uvec4 ids = texelFetch(hit_tex, pixel, 0);
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  vec3 color;
  if (ids.x == 0u) {
    color = environment(ray.direction);
  } else {
#if HAS_light_visibility
    uvec2 light_visibility = texelFetch(light_visibility_tex, pixel / params.shadow_tile, 0).xy;
    known_visible = light_visibility.x;
    known_blocked = light_visibility.y;
#endif
    uint pose = PARAM_shading == shading_frozen ? SLICE_RASTER : TIME_SLICE;
    color = shade(pose, hitOnTriangle(TIME_SLICE, ray, ids.x - 1u, ids.y, ids.z));
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(color_img, pixel, quantisedColor(vec4(color, 1)));
}
