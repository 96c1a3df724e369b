// SPDX-License-Identifier: MIT
// Splits the motion of a layer into two linear segments, before and after the raster time.
// In:  `depth`:    view depth, m; +inf for the sky, 0 where the layer has no surface
//      `id`:       instance + 1; 0 for the sky
//      `velocity`: px over the exposure
// Out: `before`:   velocity before the raster time, scaled to the whole exposure, px
//      `after`:    velocity after the raster time, scaled to the whole exposure, px
// Method: pose the point at both ends of the exposure and divide each path by its part of the exposure. A point at y at the
//      raster time is at y + before * t for t < 0 and at y + after * t for t > 0. Both outputs equal `velocity` if the exposure
//      lies on one side of the raster time, or if joints or morph targets deform the instance: `id` does not identify the point
//      then.
// Fails: motion that changes direction or speed at any time other than the raster time.
#include "lib/blur.glsl"
#include "mixin/quantised.glsl"
#include "mixin/surface.glsl"

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
