// SPDX-License-Identifier: MIT
// Needs: color_tex, hit_tex, rays, scene; may have: PARAM_displacement.
// Nearest surface at a pixel at many times of the exposure. If the camera is static, all rays of a pixel are one ray in space,
// and the static surface on this ray (the static background) is found only once. Rays at other times then test only the moving
// instances in front of this background.
#ifndef STROBE_STATIC_BACKGROUND_GLSL
#define STROBE_STATIC_BACKGROUND_GLSL
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"
#include "mixin/shade.glsl"

// Upper bound of t for a ray without an end.
const float kFar = 3.0e38;

// Static background on the ray of a pixel, under a static camera.
struct StaticBackground {
  bool is_known;  // false: the other members have no meaning, and rays test all instances
  Hit hit;        // a miss if the background is the sky
  float t;        // view depth, metres; kFar for the sky
  vec3 color;     // linear radiance
};

// True if the hit can be a static background: hit instance (or sky) and camera are static.
bool isStaticBackground(Hit hit) { return frame.camera_rests != 0u && isAtRest(hit); }

// Known static background from a hit (or a miss, for the sky) and its linear radiance.
StaticBackground staticBackgroundOf(Hit hit, vec3 color) {
  return StaticBackground(true, hit, isHit(hit) ? hit.t : kFar, color);
}

// True if the hit is on the border of its triangle. Points that the raster finds in the triangle only by rounding count too,
// because `hitOnTriangle` moves them to the border.
bool isOnBorder(Hit hit) {
  vec3 weights = cornerWeights(hit.barycentrics);
  return min(weights.x, min(weights.y, weights.z)) <= 1e-6;
}

// True if one of the 8 neighbours of the pixel shows another static surface or the sky. By rounding, the raster may have missed
// that surface at the pixel. `thing`: instance + 1 and geometry that the pixel shows.
bool isBesideOther(ivec2 pixel, uvec2 thing) {
  for (int k = 0; k < 9; ++k) {
    ivec2 at = clampToImage(pixel + ivec2(k % 3, k / 3) - 1, ivec2(frame.size));
    uvec2 other = texelFetch(hit_tex, at, 0).xy;
    if (other != thing && (other.x == 0u || instanceAt(other.x - 1u).moves == 0u)) return true;
  }
  return false;
}

// Static background of a pixel from the raster layer, without a ray. The static surface that the raster layer shows at the
// pixel is the static background, because no other static surface is nearer. Unknown if the camera or the shown surface moves.
// Also unknown at silhouettes and borders of triangles, where a ray may hit another surface than the raster.
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

// Nearest surface on a pixel's ray, with the scene posed at the time `slice`; a miss for the sky. `static_background`: static
// background on this ray. If the background is known, the ray tests only moving instances in front of the background.
Hit nearestAt(uint slice, Ray ray, StaticBackground static_background) {
  uint mask = static_background.is_known ? RAYS_TO_MOVING : RAYS_TO_ALL;
  Hit hit = traceExcept(slice, mask, ray, scene_cameras[slice].near, static_background.t, NO_INSTANCE, NO_INSTANCE);
  if (isHit(hit)) return hitOnTriangle(slice, ray, hit.instance, hit.geometry, hit.primitive);
  return static_background.hit;
}

#endif
