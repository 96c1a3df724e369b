// SPDX-License-Identifier: MIT
// How far the paths of a layer's surfaces are from straight lines: at the middle of the exposure, from the middle between
// where they are at its ends. In a loop whose one time is that.
// In:  depth (view depth, m, sky +inf, 0 where the layer has nothing), id (instance + 1, 0 = sky), velocity (px over the
//      exposure).
// Out: bend (that, px), bent (1 where it is more than `most_bend` px).
#include "lib/blur.glsl"
#include "mixin/surface.glsl"

vec2 pathOfPoint(uint slice, uint instance, vec3 position_ws) {
  vec3 capture_vs = viewFromWorld(SLICE_CAPTURE, carriedBy(instance, SLICE_CAPTURE, position_ws));
  return pathFromCapture(capture_vs, slice, viewFromWorld(slice, carriedBy(instance, slice, position_ws)));
}

vec2 pathOfTexel(uint slice, Ray ray, uint id, float depth) {
  if (id == 0u) return pathOfSky(slice, ray.direction);
  return pathOfPoint(slice, id - 1u, ray.origin + ray.direction * depth);
}

void run(ivec2 pixel) {
  vec2 d = vec2(texelFetch(velocity_tex, pixel, 0)), bend = vec2(0);
  float depth = texelFetch(depth_tex, pixel, 0).x;
  if (depth > 0.0 && d != vec2(0)) {
    Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(pixel));
    uint id = texelFetch(id_tex, pixel, 0).x;
    vec2 ends = pathOfTexel(SLICE_OPEN, ray, id, depth) + pathOfTexel(SLICE_CLOSE, ray, id, depth);
    bend = pathOfTexel(SLICE_SAMPLE, ray, id, depth) - 0.5 * ends;
  }
  bool bent = !(lengthOf(bend) <= params.most_bend);
  imageStore(bent_img, pixel, vec4(bent ? 1 : 0));
  imageStore(bend_img, pixel, vec4(bend, 0, 0));
}
