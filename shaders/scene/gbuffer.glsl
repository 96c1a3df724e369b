// SPDX-License-Identifier: MIT
// In:  hit_tex (instance + 1, geometry, primitive).
// Out: depth (view depth, m, +inf for sky), normal (unit, world), id (instance + 1, geometry + 1), velocity (px over
//      the exposure: `displacement`); depth and velocity as memory keeps them (lib/stored.glsl).
// Fails: one displacement per pixel, a straight line whatever the motion within the exposure.
#include "lib/stored.glsl"
#include "lib/surface.glsl"

void run(ivec2 pixel) {
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  float depth = uintBitsToFloat(0x7f800000u);
  vec3 normal = vec3(0);
  uvec2 id = uvec2(0);
  vec2 velocity = displacementOfSky(ray.direction);
  if (seen.x != 0u) {
    Hit hit = hitOnTriangle(TIME_SLICE, ray, seen.x - 1u, seen.y, seen.z);
    depth = hit.t;
    normal = surfaceOf(TIME_SLICE, hit).normal_ws;
    id = uvec2(seen.x, seen.y + 1u);
    velocity = displacementOf(hit);
  }
  imageStore(depth_img, pixel, vec4(storedDepth(depth)));
  imageStore(normal_img, pixel, vec4(normal, 0));
  imageStore(id_img, pixel, uvec4(id, 0u, 0u));
  imageStore(velocity_img, pixel, vec4(storedVelocity(velocity), 0, 0));
}
