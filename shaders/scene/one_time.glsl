// SPDX-License-Identifier: MIT
// One sample of the exposure per pixel: each draws one of the loop's times and sees the scene as it truly stands then, shaded as at
// the capture (Cook, Porter, Carpenter 1984, "Distributed Ray Tracing").
// In:  color (linear) and velocity (px over the exposure) of what the capture sees, dominant (the same, per tile).
// Out: noisy (linear, alpha 1), moved (px over the exposure, of what is seen then). Where nothing moves around, what the capture sees.
// Its mean over seeds is that over the loop's times.
#include "lib/blur.glsl"
#include "lib/noise.glsl"
#include "mixin/shade.glsl"

uint keyOfFrame() {
#if PARAM_jitter_frame == jitter_frame_per_frame
  return noiseKey(frame.frame, frame.seed);
#else
  return noiseKey(0u, frame.seed);
#endif
}

void run(ivec2 pixel) {
  vec4 color = texelFetch(color_tex, pixel, 0);
  vec2 moved = finiteDisplacement(texelFetch(velocity_tex, pixel, 0));
  vec2 d = vec2(texelFetch(dominant_tex, pixel / params.tile, 0));
  if (reachFactor(frame.shutter) * lengthOf(d) > kStillRadius) {
    count_rays(1u);
    uint slice = TIME_SLICE + pixelHash(pixel, keyOfFrame()) % max(frame.slice_count, 1u);
    Ray ray = cameraRay(slice, samplePosition(pixel));
    Hit hit = traceNearest(slice, ray, scene_cameras[slice].near, 3.0e38);
    if (isHit(hit)) {
      hit = hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive);
      color = vec4(shade(SLICE_CAPTURE, hit), 1);
      moved = displacementOf(hit, positionOf(SLICE_CAPTURE, hit));
    } else {
      color = vec4(environment(ray.direction), 1);
      moved = displacementOfSky(ray.direction);
    }
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(noisy_img, pixel, vec4(vec3(color), 1));
  imageStore(moved_img, pixel, vec4(finiteDisplacement(vec4(moved, 0, 0)), 0, 0));
}
