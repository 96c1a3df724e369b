// SPDX-License-Identifier: MIT
// Needs: color_tex, hit_tex, rays, scene; may have: PARAM_displacement.
// Nearest surface at a pixel at many times. If the camera is static, the static background on the pixel's ray is found once.
// Rays at other times then test only the moving instances in front of this background.
#ifndef STROBE_GROUND_GLSL
#define STROBE_GROUND_GLSL
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"
#include "mixin/shade.glsl"

const float kFar = 3.0e38;

// Static background on the ray of a pixel, for a static camera.
struct StaticBackground {
  bool is_known;
  Hit hit;
  float t;  // distance along the ray; view depth, metres
  vec3 color;
};

// True if the hit is static and the camera is static.
bool isStaticBackground(Hit hit) { return frame.camera_rests != 0u && isAtRest(hit); }

StaticBackground staticBackgroundOf(Hit hit, vec3 color) {
  return StaticBackground(true, hit, isHit(hit) ? hit.t : kFar, color);
}

// True if the hit is on the border of its triangle. Points that the raster places in the triangle only by rounding are on the
// border too, because `hitOnTriangle` moves them there.
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

// Static background of a pixel whose raster image shows a static surface; no other static surface is nearer. The background is
// unknown at silhouettes and at borders of triangles, where a ray may hit another surface than the raster.
StaticBackground staticBackgroundAt(ivec2 pixel) {
  StaticBackground static_background = StaticBackground(false, noHit(), kFar, vec3(0));
  if (frame.camera_rests == 0u) return static_background;
  uvec4 ids = texelFetch(hit_tex, pixel, 0);
  if (ids.x != 0u && instanceAt(ids.x - 1u).moves != 0u) return static_background;
  if (isBesideOther(pixel, ids.xy)) return static_background;
  Hit hit = noHit();
  if (ids.x != 0u) {
    hit = hitOnTriangle(SLICE_RASTER, cameraRay(SLICE_RASTER, samplePosition(pixel)), ids.x - 1u, ids.y, ids.z);
    if (isOnBorder(hit)) return static_background;
  }
  return staticBackgroundOf(hit, finiteColor(texelFetch(color_tex, pixel, 0)));
}

// Nearest surface on a pixel's ray at a slice.
Hit nearestAt(uint slice, Ray ray, StaticBackground static_background) {
  uint mask = static_background.is_known ? RAYS_TO_MOVING : RAYS_TO_ALL;
  Hit hit = traceExcept(slice, mask, ray, scene_cameras[slice].near, static_background.t, NO_INSTANCE, NO_INSTANCE);
  if (isHit(hit)) return hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive);
  return static_background.hit;
}

#endif
