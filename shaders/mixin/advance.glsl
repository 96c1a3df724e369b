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

// A point of a surface, moved off it to the side that is not seen: 256 representable numbers per coordinate along the
// normal, and where a coordinate is below 1/32 of the largest, 1/65536 of that. Waechter and Binder, "A Fast and Robust
// Method for Avoiding Self-Intersection" (Ray Tracing Gems, 2019), whose scene is about as large as 1.
vec3 onFarSide(Hit hit) {
  Surface surface = surfaceOf(SLICE_CAPTURE, hit);
  vec3 p = surface.position_ws, normal = -surface.face_normal_ws;
  float largest = max(abs(p.x), max(abs(p.y), abs(p.z)));
  vec3 moved;
  for (int axis = 0; axis < 3; ++axis) {
    int steps = int(256.0 * normal[axis]);
    float stepped = intBitsToFloat(floatBitsToInt(p[axis]) + (p[axis] < 0.0 ? -steps : steps));
    moved[axis] = abs(p[axis]) < largest / 32.0 ? p[axis] + largest / 65536.0 * normal[axis] : stepped;
  }
  return moved;
}

// A new ray from the far side of the surface that was hit.
Hit nextFromFarSide(Ray ray, Hit last) {
  Hit hit = traceNearest(SLICE_CAPTURE, Ray(onFarSide(last), ray.direction), 0.0, kFar);
  hit.t += last.t;
  return hit;
}

#endif
