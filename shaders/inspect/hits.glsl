// SPDX-License-Identifier: MIT
// Hits of one camera ray at the raster time, nearest first, for the inspection of a pixel. Texel k of the output is hit k,
// counted from 0.
// In:  none; the parameters `pixel_x` and `pixel_y` select the pixel.
// Out: `hit`: instance + 1, geometry + 1, primitive, 1 for a front face; 0 after the last hit.
//      `where`: x: view depth, metres; yzw: unit normal in world space.
//      `velocity`: displacement, px over the exposure.
//      `color`: linear radiance; alpha 1 for a hit, otherwise 0.
// Method: each texel traces the ray from the camera up to its own hit. From hit to hit the ray keeps its origin, and its lower
//   bound is set 4 representable numbers beyond the last hit. A repeated hit on the same triangle is not counted.
// Fails: only one of two coincident surfaces is listed.
#include "mixin/advance.glsl"
#include "mixin/shade.glsl"

// Hit number `wanted`, counted from 0; a miss if the ray has fewer hits.
Hit hitNumber(Ray ray, int wanted) {
  Hit last = traceNearest(SLICE_RASTER, ray, scene_cameras[SLICE_RASTER].near, kFar);
  int number = 0;
  while (number < wanted && isHit(last)) {
    Hit next = nextAlong(ray, last, NO_INSTANCE, NO_INSTANCE);
    if (!isSameTriangle(next, last)) ++number;
    last = next;
  }
  return last;
}

void run(ivec2 texel) {
  Ray ray = cameraRay(SLICE_RASTER, samplePosition(ivec2(params.pixel_x, params.pixel_y)));
  Hit hit = hitNumber(ray, texel.x);
  uvec4 name = uvec4(0);
  vec4 where = vec4(0), color = vec4(0);
  vec2 velocity = vec2(0);
  if (isHit(hit)) {
    hit = hitOnTriangle(SLICE_RASTER, ray, hit.instance, hit.geometry, hit.primitive);
    name = uvec4(hit.instance + 1u, hit.geometry + 1u, hit.primitive, hit.front ? 1u : 0u);
    where = vec4(hit.t, surfaceOf(SLICE_RASTER, hit).normal_ws);
    velocity = displacementOf(hit, ray.origin + ray.direction * hit.t);
    color = vec4(shade(SLICE_RASTER, hit), 1);
  }
  imageStore(hit_img, texel, name);
  imageStore(where_img, texel, where);
  imageStore(velocity_img, texel, vec4(velocity, 0, 0));
  imageStore(color_img, texel, color);
}
