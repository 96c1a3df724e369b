// SPDX-License-Identifier: MIT
// Needs: rays, scene; may have: PARAM_displacement.
// From one hit of a camera's ray to the next one behind it. No way of advancing contains a length: all of them scale.
#ifndef STROBE_ADVANCE_GLSL
#define STROBE_ADVANCE_GLSL
#include "mixin/trace.glsl"

const float kFar = 3.0e38;

// Four representable numbers further: with intervals open at their ends the hit itself is not found again, and of true
// layers only those within rounding of it, which read as one with it.
float justBehind(float t) { return uintBitsToFloat(floatBitsToUint(t) + 4u); }

// A ray meets a triangle once: the same triangle again is the same hit.
bool isSameTriangle(Hit a, Hit b) {
  return a.instance == b.instance && a.geometry == b.geometry && a.primitive == b.primitive;
}

// Keeping the ray and raising its lower bound; hits on `skip_instance` (or one geometry of it) do not exist.
Hit nextAlong(Ray ray, Hit last, uint skip_instance, uint skip_geometry) {
  return traceExcept(SLICE_CAPTURE, RAYS_TO_ALL, ray, justBehind(last.t), kFar, skip_instance, skip_geometry);
}

// A new ray from the hit, which starts a hundred-thousandth of the depth later. Tan, Cui, Bhojan 2020.
Hit nextFromHit(Ray ray, Hit last) {
  Ray onward = Ray(ray.origin + ray.direction * last.t, ray.direction);
  Hit hit = traceNearest(SLICE_CAPTURE, onward, 1e-5 * last.t, kFar);
  hit.t += last.t;
  return hit;
}

#endif
