// SPDX-License-Identifier: MIT
// Radiance of each pixel at one random time of the exposure (Cook, Porter, Carpenter 1984, "Distributed Ray Tracing").
// In:  `color`: linear radiance at the raster time
//      `velocity`: displacement of the surface at the raster time, px over the exposure
//      `dominant`: longest displacement that reaches the tile, px over the exposure
// Out: `noisy`: linear radiance at the drawn time, alpha 1
//      `moved`: displacement of the surface hit at the drawn time, px over the exposure
// Method: draw one of the loop's times by a hash of pixel, frame and seed, trace the scene as posed at that time, and shade the
//   hit as at the raster time. The mean over seeds is the mean over the loop's times. Copy `color` and `velocity` where
//   `dominant` moves no surface by more than half a pixel.
// Fails: noise, because one time represents the whole exposure. A surface that enters the image where no tile has a
//   displacement is missed.
#include "lib/blur.glsl"
#include "lib/noise.glsl"
#include "mixin/shade.glsl"

// Key of the noise: differs from frame to frame only with jitter_frame = per_frame.
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
  if (spreadFactor(frame.shutter) * lengthOf(d) > kStaticRadius) {
    count_rays(1u);
    uint slice = TIME_SLICE + pixelHash(pixel, keyOfFrame()) % max(frame.slice_count, 1u);
    Ray ray = cameraRay(slice, samplePosition(pixel));
    Hit hit = traceNearest(slice, ray, scene_cameras[slice].near, 3.0e38);
    if (isHit(hit)) {
      hit = hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive);
      color = vec4(shade(SLICE_RASTER, hit), 1);
      moved = displacementOf(hit, positionOf(SLICE_RASTER, hit));
    } else {
      color = vec4(environment(ray.direction), 1);
      moved = displacementOfSky(ray.direction);
    }
  }
  if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  imageStore(noisy_img, pixel, vec4(vec3(color), 1));
  imageStore(moved_img, pixel, vec4(finiteDisplacement(vec4(moved, 0, 0)), 0, 0));
}
