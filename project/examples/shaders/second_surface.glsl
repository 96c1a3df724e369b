// SPDX-License-Identifier: MIT
// Average of the colours of the first two instances on the camera's ray.
// In:  `hit`:     instance + 1 (0 for the sky), geometry, primitive.
//      `color`:   linear radiance of the visible surface.
// Out: `picture`: linear radiance, alpha 1.
// Method: intersect the ray with the visible triangle. Trace on from the hit point, and skip the visible instance.
// Fails: a second layer of the same instance is skipped.
#include "mixin/advance.glsl"
#include "mixin/shade.glsl"

void run(ivec2 pixel) {
  vec3 color = color_at(pixel).rgb;
  uvec4 ids = hit_at(pixel);
  if (ids.x != 0u) {  // not the sky
    Ray ray = cameraRay(SLICE_RASTER, samplePosition(pixel));
    Hit first = hitOnTriangle(SLICE_RASTER, ray, ids.x - 1u, ids.y, ids.z);
    Hit second = nextAlong(ray, first, first.instance, NO_INSTANCE);
    if (isHit(second)) {
      color = mix(color, shade(SLICE_RASTER, second), params.share);
      count_found(1u);
    }
  }
  imageStore(picture_img, pixel, vec4(color, 1));
}
