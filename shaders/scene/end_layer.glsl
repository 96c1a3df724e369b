// SPDX-License-Identifier: MIT
// What an end of the exposure sees and no layer of the capture holds, as a layer: shaded as at the capture.
// In:  hit (of the end that `end_of` names), unseen (> 1/2: no layer holds it).
// Out: color (linear radiance), depth (view depth at that end, sky +inf); both 0 where something else holds it.
#include "mixin/shade.glsl"
#include "mixin/stored.glsl"

#if PARAM_end_of == end_of_start
const uint kEnd = SLICE_OPEN;
#else
const uint kEnd = SLICE_CLOSE;
#endif

void run(ivec2 pixel) {
  vec4 color = vec4(0);
  float depth = 0.0;
  if (texelFetch(unseen_tex, pixel, 0).x > 0.5) {
    uvec4 seen = texelFetch(hit_tex, pixel, 0);
    Ray ray = cameraRay(kEnd, samplePosition(pixel));
    if (seen.x == 0u) {
      color = vec4(environment(ray.direction), 1);
      depth = 1.0 / 0.0;
    } else {
      Hit hit = hitOnTriangle(kEnd, ray, seen.x - 1u, seen.y, seen.z);
      color = vec4(shade(SLICE_CAPTURE, hit), 1);
      depth = hit.t;
    }
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(color_img, pixel, storedColor(color));
  imageStore(depth_img, pixel, vec4(depth));
}
