// SPDX-License-Identifier: MIT
// In:  hit_tex, sure_tex (rays that need not be traced, of `shadow_shafts`).
// Out: color (linear radiance), as memory keeps it (mixin/stored.glsl).
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
