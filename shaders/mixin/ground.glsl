// SPDX-License-Identifier: MIT
// Needs: color_tex, hit_tex, rays, scene; may have: PARAM_displacement.
// Nearest surface at a pixel at many times. If the camera is static, the static background on the pixel's ray is found once.
// Rays at other times then test only the moving instances in front.
#ifndef STROBE_GROUND_GLSL
#define STROBE_GROUND_GLSL
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"
#include "mixin/shade.glsl"

const float kFar = 3.0e38;

// Static background on the ray of a pixel, for a static camera.
struct Ground {
  bool is_known;
  Hit hit;
  float t;  // distance along the ray; view depth, metres
  vec3 color;
};

// True if the hit is static and the camera is static.
bool isGround(Hit hit) { return frame.camera_rests != 0u && isAtRest(hit); }

Ground groundOf(Hit hit, vec3 color) { return Ground(true, hit, isHit(hit) ? hit.t : kFar, color); }

// True if the point is on the border of its triangle. `hitOnTriangle` also moves points to the border that the raster places
// in the triangle only by rounding.
bool isOnBorder(Hit hit) {
  vec3 weights = cornerWeights(hit.barycentrics);
  return min(weights.x, min(weights.y, weights.z)) <= 1e-6;
}

// True if one of the 8 neighbours shows another static surface, which rounding in the raster may have hidden from the pixel.
// `thing`: instance + 1 and geometry of the pixel.
bool isBesideOther(ivec2 pixel, uvec2 thing) {
  for (int k = 0; k < 9; ++k) {
    ivec2 at = clampToImage(pixel + ivec2(k % 3, k / 3) - 1, ivec2(frame.size));
    uvec2 other = texelFetch(hit_tex, at, 0).xy;
    if (other != thing && (other.x == 0u || instanceAt(other.x - 1u).moves == 0u)) return true;
  }
  return false;
}

// Static background from the raster image, if the pixel shows a static surface there: no static surface is nearer. Unknown at
// silhouettes and borders of triangles, where a ray may hit another surface than the raster.
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

// Nearest surface on a pixel's ray at a slice.
Hit nearestAt(uint slice, Ray ray, Ground ground) {
  uint mask = ground.is_known ? RAYS_TO_MOVING : RAYS_TO_ALL;
  Hit hit = traceExcept(slice, mask, ray, scene_cameras[slice].near, ground.t, NO_INSTANCE, NO_INSTANCE);
  if (isHit(hit)) return hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive);
  return ground.hit;
}

#endif
