// SPDX-License-Identifier: MIT
// Needs: rays, scene; may have: PARAM_displacement.
// Search for the next hit behind a known hit, on a camera's ray at the raster time. The least distance between the two hits is
// proportional to the depth, so that the functions work at any scale of the scene.
#ifndef STROBE_ADVANCE_GLSL
#define STROBE_ADVANCE_GLSL
#include "mixin/trace.glsl"

// Upper bound of t for a ray without an end.
const float kFar = 3.0e38;

// Start of the ray interval behind a hit at the distance t > 0, for the search for the next hit: the fourth
// representable float above t. The hit itself is then normally not found again; `isSameTriangle` detects a repetition.
// Other surfaces between t and this start are skipped too. Their distance from the hit is as small as the rounding
// errors of t.
float justBeyond(float t) { return uintBitsToFloat(floatBitsToUint(t) + 4u); }

// True if both hits are on one triangle. A ray meets a triangle at most once, so two hits of one ray on one triangle are one
// hit that was found twice.
bool isSameTriangle(Hit a, Hit b) {
  return a.instance == b.instance && a.geometry == b.geometry && a.primitive == b.primitive;
}

// Nearest hit on `ray` behind the hit `last` of this ray, at the raster time; a miss if no surface follows. Hits on the
// instance `skip_instance` are ignored (NO_INSTANCE: ignore nothing). If `skip_geometry` is not NO_INSTANCE, only hits on this
// geometry of the instance are ignored.
Hit nextAlong(Ray ray, Hit last, uint skip_instance, uint skip_geometry) {
  return traceExcept(SLICE_RASTER, RAYS_TO_ALL, ray, justBeyond(last.t), kFar, skip_instance, skip_geometry);
}

// Nearest hit on a new ray that starts at the hit `last` of `ray`, at the raster time; a miss if no surface follows. Hits that
// are closer to `last` than 1e-5 of the depth of `last` are ignored (Tan, Cui, Bhojan 2020). The result's t is counted from the
// origin of `ray`.
Hit nextFromHit(Ray ray, Hit last) {
  Ray onward = Ray(ray.origin + ray.direction * last.t, ray.direction);
  Hit hit = traceNearest(SLICE_RASTER, onward, 1e-5 * last.t, kFar);
  hit.t += last.t;
  return hit;
}

#endif
