// SPDX-License-Identifier: MIT
// In:  hit_tex. Out: color (linear radiance).
#include "lib/shade.glsl"

void run(ivec2 pixel) {
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  vec3 color;
  if (seen.x == 0u) {
    color = environment(ray.direction);
  } else {
    uint pose = PARAM_shading == shading_frozen ? SLICE_CAPTURE : TIME_SLICE;
    color = shade(pose, hitOnTriangle(TIME_SLICE, ray, seen.x - 1u, seen.y, seen.z));
  }
  imageStore(color_img, pixel, vec4(color, 1));
}
