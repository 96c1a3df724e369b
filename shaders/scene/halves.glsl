// SPDX-License-Identifier: MIT
// The displacements of a layer in the two parts of the exposure, before and after the capture, each from the true poses
// at its ends: motion that is piecewise linear instead of linear.
// In:  depth (view depth, m, sky +inf, 0 where the layer has nothing), id (instance + 1, 0 = sky) and velocity (px over
//      the exposure) of the layer.
// Out: before, after (px over the exposure, at the pace of that part: a point now at y is at y + before*t for t < 0 and
//      at y + after*t for t > 0). An exposure that has one of the parts only has `velocity` for both, and so has what
//      joints or morph targets bend: `id` does not say which point of it that is.
// Fails: motion that bends elsewhere than at the capture.
#include "lib/blur.glsl"
#include "mixin/stored.glsl"
#include "mixin/surface.glsl"

vec2 pathOfTexel(uint slice, Ray ray, uint id, float depth) {
  if (id == 0u) return pathOfSky(slice, ray.direction);
  return pathOfPoint(slice, id - 1u, ray.origin + ray.direction * depth);
}

void run(ivec2 pixel) {
  vec2 before = vec2(texelFetch(velocity_tex, pixel, 0)), after = before;
  float depth = texelFetch(depth_tex, pixel, 0).x;
  uint id = texelFetch(id_tex, pixel, 0).x;
  if (isCentred(frame.shutter) && depth > 0.0 && (id == 0u || !bends(id - 1u))) {
    Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(pixel));
    before = pathOfTexel(SLICE_OPEN, ray, id, depth) / frame.shutter.x;
    after = pathOfTexel(SLICE_CLOSE, ray, id, depth) / frame.shutter.y;
  }
  imageStore(before_img, pixel, vec4(storedVelocity(before), 0, 0));
  imageStore(after_img, pixel, vec4(storedVelocity(after), 0, 0));
}
