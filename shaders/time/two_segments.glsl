// SPDX-License-Identifier: MIT
// Splits the motion of a layer into two linear segments, before and after the raster time.
// In:  `depth`: view depth, metres; +inf for the sky, 0 where the layer has no surface
//      `id`: instance + 1; 0 for the sky
//      `velocity`: displacement, px over the exposure
// Out: `velocity_pre`: velocity before the raster time, scaled to the whole exposure, px
//      `velocity_post`: velocity after the raster time, scaled to the whole exposure, px
// Method: pose the point at the times t of shutter open (t < 0) and shutter close (t > 0), in exposures from the raster
//   time. At each of the two times, subtract the position at the raster time, and divide the difference by t. A point
//   that is at y at the raster time is then at y + velocity_pre * t for t < 0 and at y + velocity_post * t for t > 0.
//   Both outputs equal `velocity` in two cases: if the exposure lies on one side of the raster time, and if joints or
//   morph targets deform the instance, because `id` then does not identify the point.
// Fails: motion that changes direction or speed at any time other than the raster time.
#include "lib/blur.glsl"
#include "mixin/quantised.glsl"
#include "mixin/surface.glsl"

// Screen offset of the surface at a texel from the raster time to the time of `slice`, px. `id`: instance + 1; 0 for the sky.
// `depth`: view depth, metres.
vec2 pathOfTexel(uint slice, Ray ray, uint id, float depth) {
  if (id == 0u) return pathOfSky(slice, ray.direction);
  return pathOfPoint(slice, id - 1u, ray.origin + ray.direction * depth);
}

void run(ivec2 pixel) {
  vec2 velocity_pre = vec2(texelFetch(velocity_tex, pixel, 0)), velocity_post = velocity_pre;
  float depth = texelFetch(depth_tex, pixel, 0).x;
  uint id = texelFetch(id_tex, pixel, 0).x;
  if (isCentred(frame.shutter) && depth > 0.0 && (id == 0u || !deforms(id - 1u))) {
    Ray ray = cameraRay(SLICE_RASTER, samplePosition(pixel));
    velocity_pre = pathOfTexel(SLICE_SHUTTER_OPEN, ray, id, depth) / frame.shutter.x;
    velocity_post = pathOfTexel(SLICE_SHUTTER_CLOSE, ray, id, depth) / frame.shutter.y;
  }
  imageStore(velocity_pre_img, pixel, vec4(quantisedVelocity(velocity_pre), 0, 0));
  imageStore(velocity_post_img, pixel, vec4(quantisedVelocity(velocity_post), 0, 0));
}
