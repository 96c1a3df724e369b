// SPDX-License-Identifier: MIT
// Adds what a pixel sees at one time of the loop, shaded as at the capture, to the mean of such samples.
// In:  hit (what moves and is seen then; before a moving camera all); color, depth, id of what the capture sees; ground
//      (alpha: view depth of what is at rest behind what the capture sees in motion, else 0).
// Updates: moving (rgb: mean, linear; alpha: number of samples). Before a camera at rest what rests is not added: it is known.
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

// Of what is at rest on the pixel's ray, before a camera at rest.
float groundDepth(ivec2 pixel) {
  float behind = texelFetch(ground_tex, pixel, 0).a;
  return behind > 0.0 ? behind : texelFetch(depth_tex, pixel, 0).x;
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
  if (camera_rests && !(hit.t < groundDepth(pixel))) return;
  vec3 color = isHit(hit) ? colorOf(hit) : environment(ray.direction);
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(moving_img, pixel, withSample(imageLoad(moving_img, pixel), color));
}
