// SPDX-License-Identifier: MIT
// Needs: rays, scene; may have: PARAM_displacement.
// Steps along a camera's ray from one hit to the next hit behind it. Step lengths are proportional to the depth, so that they
// work at any scale of the scene.
#ifndef STROBE_ADVANCE_GLSL
#define STROBE_ADVANCE_GLSL
#include "mixin/trace.glsl"

const float kFar = 3.0e38;

// Distance that is four representable floats beyond t. Ray intervals are open at their ends, so the hit at t is not found
// again. Other surfaces within this distance are skipped too; at single precision they coincide with the hit.
float justBeyond(float t) { return uintBitsToFloat(floatBitsToUint(t) + 4u); }

// True if both hits are on one triangle. A ray meets a triangle once, so the same triangle means the same hit.
bool isSameTriangle(Hit a, Hit b) {
  return a.instance == b.instance && a.geometry == b.geometry && a.primitive == b.primitive;
}

// Next hit on the same ray, beyond the hit `last`. Hits on the instance `skip_instance` are ignored; if `skip_geometry` is not
// NO_INSTANCE, only hits on this geometry of the instance.
Hit nextAlong(Ray ray, Hit last, uint skip_instance, uint skip_geometry) {
  return traceExcept(SLICE_RASTER, RAYS_TO_ALL, ray, justBeyond(last.t), kFar, skip_instance, skip_geometry);
}

// Next hit on a new ray that starts at the hit `last` and ignores hits nearer than 1e-5 of that hit's depth (Tan, Cui, Bhojan
// 2020).
Hit nextFromHit(Ray ray, Hit last) {
  Ray onward = Ray(ray.origin + ray.direction * last.t, ray.direction);
  Hit hit = traceNearest(SLICE_RASTER, onward, 1e-5 * last.t, kFar);
  hit.t += last.t;
  return hit;
}

#endif
