// SPDX-License-Identifier: MIT
// Before a camera at rest, what is at rest on each pixel's ray: what the capture sees, or what rays find behind it where
// that may move. Before a moving one, what the capture sees.
// In:  hit, color (linear), depth (view depth, m, sky +inf) of what the capture sees.
// Out: ground (linear; alpha: view depth, m, +inf without a surface).
#include "lib/sanitise.glsl"
#include "mixin/shade.glsl"

bool isMoving(uvec4 seen) { return seen.x != 0u && instanceAt(seen.x - 1u).moves != 0u; }

// The nearest surface at rest. Each ray goes on where the last one met something that may move, past all of that instance.
Hit atRestOn(Ray ray, uint first_moving) {
  Hit hit = traceExcept(SLICE_CAPTURE, RAYS_TO_ALL, ray, scene_cameras[SLICE_CAPTURE].near, 3.0e38, first_moving, NO_INSTANCE);
  while (!isAtRest(hit))
    hit = traceExcept(SLICE_CAPTURE, RAYS_TO_ALL, ray, hit.t, 3.0e38, hit.instance, NO_INSTANCE);
  return hit;
}

void run(ivec2 pixel) {
  vec4 ground = vec4(finiteColor(texelFetch(color_tex, pixel, 0)), texelFetch(depth_tex, pixel, 0).x);
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  if (frame.camera_rests != 0u && isMoving(seen)) {
    count_rays(1u);
    Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(pixel));
    Hit hit = atRestOn(ray, seen.x - 1u);
    if (isHit(hit)) {
      hit = hitOnTriangle(SLICE_CAPTURE, ray, hit.instance, hit.geometry, hit.primitive);
      ground = vec4(shade(SLICE_CAPTURE, hit), hit.t);
    } else {
      ground = vec4(environment(ray.direction), uintBitsToFloat(0x7f800000u));
    }
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(ground_img, pixel, ground);
}
