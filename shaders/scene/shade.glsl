// SPDX-License-Identifier: MIT
// Linear radiance of the surface at each pixel, with traced shadows.
// In:  `hit`:   instance + 1 (0 = sky), geometry, primitive
//      `sure`:  per shadow tile, one bit per light: x visible from the whole tile, y blocked from the whole tile (of
//               `shadow_shafts`); absent: unknown
// Out: `color`: linear radiance, alpha 1; quantised (mixin/stored.glsl)
// Method: intersect the pixel's ray with the triangle at the node's time and shade the point (mixin/shade.glsl), posed at the
//      raster time (`shading` = frozen) or at the node's time (full). Lights in `sure` need no shadow ray.
// Fails: with frozen shading, lights, shadows and highlights do not move within the exposure.
#if HAS_sure
#define STROBE_KEEPS_SHADOWS
#endif
#include "mixin/shade.glsl"
#include "mixin/stored.glsl"

void run(ivec2 pixel) {
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  vec3 color;
  if (seen.x == 0u) {
    color = environment(ray.direction);
  } else {
#if HAS_sure
    uvec2 sure = texelFetch(sure_tex, pixel / params.shadow_tile, 0).xy;
    known_free = sure.x;
    known_blocked = sure.y;
#endif
    uint pose = PARAM_shading == shading_frozen ? SLICE_CAPTURE : TIME_SLICE;
    color = shade(pose, hitOnTriangle(TIME_SLICE, ray, seen.x - 1u, seen.y, seen.z));
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(color_img, pixel, storedColor(vec4(color, 1)));
}
