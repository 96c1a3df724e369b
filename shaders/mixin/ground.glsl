// SPDX-License-Identifier: MIT
// Needs: color_tex, hit_tex, rays, scene; may have: PARAM_displacement.
// What a pixel sees at many times: before a camera at rest, what is at rest on its ray is found once, and what moves is
// traced before it.
#ifndef STROBE_GROUND_GLSL
#define STROBE_GROUND_GLSL
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"
#include "mixin/shade.glsl"

const float kFar = 3.0e38;

// What is at rest on a pixel's ray, before a camera at rest.
struct Ground {
  bool is_known;
  Hit hit;
  float t;  // as a ray measures it
  vec3 color;
};

bool isGround(Hit hit) { return frame.camera_rests != 0u && isAtRest(hit); }

Ground groundOf(Hit hit, vec3 color) { return Ground(true, hit, isHit(hit) ? hit.t : kFar, color); }

// Is a point on the border of its triangle? Those beside it, which only raster's rounding finds there, are moved to it.
bool isOnBorder(Hit hit) {
  vec3 weights = cornerWeights(hit.barycentrics);
  return min(weights.x, min(weights.y, weights.z)) <= 1e-6;
}

// Does a pixel around it show another thing at rest? Raster's rounding may have kept that from this one.
bool isBesideOther(ivec2 pixel, uvec2 thing) {
  for (int k = 0; k < 9; ++k) {
    ivec2 at = clampToImage(pixel + ivec2(k % 3, k / 3) - 1, ivec2(frame.size));
    uvec2 other = texelFetch(hit_tex, at, 0).xy;
    if (other != thing && (other.x == 0u || instanceAt(other.x - 1u).moves == 0u)) return true;
  }
  return false;
}

// What the capture sees, if that is at rest: nothing at rest is nearer. Not at silhouettes, where a ray may see otherwise.
Ground groundAt(ivec2 pixel) {
  Ground ground = Ground(false, noHit(), kFar, vec3(0));
  if (frame.camera_rests == 0u) return ground;
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  if (seen.x != 0u && instanceAt(seen.x - 1u).moves != 0u) return ground;
  if (isBesideOther(pixel, seen.xy)) return ground;
  Hit hit = noHit();
  if (seen.x != 0u) {
    hit = hitOnTriangle(SLICE_CAPTURE, cameraRay(SLICE_CAPTURE, samplePosition(pixel)), seen.x - 1u, seen.y, seen.z);
    if (isOnBorder(hit)) return ground;
  }
  return groundOf(hit, finiteColor(texelFetch(color_tex, pixel, 0)));
}

// The nearest surface on a pixel's ray at a slice of time.
Hit nearestAt(uint slice, Ray ray, Ground ground) {
  uint mask = ground.is_known ? RAYS_TO_MOVING : RAYS_TO_ALL;
  Hit hit = traceExcept(slice, mask, ray, scene_cameras[slice].near, ground.t, NO_INSTANCE, NO_INSTANCE);
  if (isHit(hit)) return hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive);
  return ground.hit;
}

#endif
