// SPDX-License-Identifier: MIT
// Before a camera at rest, what rays find at rest behind what the capture sees in motion.
// In:  hit (what the capture sees).
// Out: ground (linear; alpha: view depth, m, +inf without a surface), where the capture sees something that may move.
#include "lib/reached.glsl"
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
  if (frame.camera_rests == 0u || !isReached(pixel)) return;
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  if (!isMoving(seen)) return;
  count_rays(1u);
  Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(pixel));
  Hit hit = atRestOn(ray, seen.x - 1u);
  vec4 ground = vec4(0, 0, 0, uintBitsToFloat(0x7f800000u));
  if (isHit(hit)) {
    hit = hitOnTriangle(SLICE_CAPTURE, ray, hit.instance, hit.geometry, hit.primitive);
    ground = vec4(shade(SLICE_CAPTURE, hit), hit.t);
  } else {
    ground.rgb = environment(ray.direction);
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(ground_img, pixel, ground);
}
