// SPDX-License-Identifier: MIT
// Adds what a pixel sees at one time of the loop, shaded as at the capture, to the mean of such samples.
// In:  hit (what moves and is seen then; before a moving camera all); color, depth, id of what the capture sees; ground
//      (linear; alpha: view depth of what is at rest, before a camera at rest).
// Updates: moving (rgb: mean, linear; alpha: number of samples). What is at rest is not added: it is known, `ground`.
#include "lib/mean.glsl"
#include "lib/reached.glsl"
#include "mixin/captured_color.glsl"

vec3 colorOf(Hit hit) {
#if PARAM_reused
  return capturedColorOf(hit);
#else
  count_shaded(1u);
  return shade(SLICE_CAPTURE, hit);
#endif
}

void run(ivec2 pixel) {
#if PARAM_where_reached
  if (!isReached(pixel)) return;
#endif
  bool camera_rests = frame.camera_rests != 0u;
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  if (camera_rests && (seen.x == 0u || instanceAt(seen.x - 1u).moves == 0u)) return;
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  Hit hit = noHit();
  if (seen.x != 0u) hit = hitOnTriangle(TIME_SLICE, ray, seen.x - 1u, seen.y, seen.z);
  if (camera_rests && !(hit.t < texelFetch(ground_tex, pixel, 0).a)) return;
  vec3 color = isHit(hit) ? colorOf(hit) : environment(ray.direction);
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(moving_img, pixel, withSample(imageLoad(moving_img, pixel), color));
}
