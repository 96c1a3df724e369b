// SPDX-License-Identifier: MIT
// Needs: rays, scene; may have: PARAM_displacement.
// Ray tracing: one interface over the tracing backends, which find the same hits (runtime/shader/backends.h lists them).
// The interval of a ray is open at both ends: a hit at exactly t_min (0 or more) or at t_max is not found. Rays pass through
// one-sided surfaces from behind. Only the rays of `isBlocked` hit both sides.
#ifndef STROBE_TRACE_GLSL
#define STROBE_TRACE_GLSL
#include "mixin/surface.glsl"
#include "mixin/trace_payload.glsl"

// Number of rays that this invocation traced. The runtime adds it to the pass's counter for the backend.
uint launched_rays = 0u;

struct TraceResult {
  uint instance, geometry, primitive;  // NO_INSTANCE: a miss
  vec2 barycentrics;
  float t;
};

#if defined(STROBE_BACKEND_PIPELINE)
#include "mixin/trace_pipeline.glsl"
#elif defined(STROBE_BACKEND_BVH)
#include "mixin/trace_bvh.glsl"
#else
#include "mixin/trace_query.glsl"
#endif

// True if the ray meets the triangle from its front.
bool isFrontFacing(uint slice, Ray ray, uint instance, uint geometry, uint primitive) {
  Triangle triangle = triangleOf(geometryOf(instance, geometry), primitive);
  vec3 a = vertexPosition(slice, triangle.vertex[0]);
  vec3 face_os = cross(vertexPosition(slice, triangle.vertex[1]) - a, vertexPosition(slice, triangle.vertex[2]) - a);
  return dot(normalFromObject(transformOf(slice, instance), face_os), ray.direction) < 0.0;
}

// Nearest hit with t in (t_min, t_max), except on `skip_instance` (NO_INSTANCE: skip nothing). If `skip_geometry` is not
// NO_INSTANCE, only this geometry of the instance is skipped. A miss has the instance NO_INSTANCE.
// `mask`: RAYS_TO_ALL, or RAYS_TO_MOVING for the instances that may move within the exposure.
Hit traceExcept(uint slice, uint mask, Ray ray, float t_min, float t_max, uint skip_instance, uint skip_geometry) {
  ++launched_rays;
  TraceResult found = launch(slice, mask, false, false, ray, t_min, t_max, skip_instance, skip_geometry);
  if (found.instance == NO_INSTANCE) return noHit();
  Hit hit = Hit(found.instance, found.geometry, found.primitive, found.barycentrics, found.t, true);
  hit.front = isFrontFacing(slice, ray, hit.instance, hit.geometry, hit.primitive);
  return hit;
}

// Nearest hit, for callers that use it only if it is on `instance`. The backend `bvh` tests this instance alone, so it can
// return a hit that another instance hides. The other backends test all instances.
Hit traceInstance(uint slice, uint instance, Ray ray, float t_min, float t_max) {
#ifdef STROBE_BACKEND_BVH
  uint mask = RAYS_TO_ONE + instance;
#else
  uint mask = RAYS_TO_ALL;
#endif
  return traceExcept(slice, mask, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE);
}

// Nearest hit with t in (t_min, t_max) on any instance.
Hit traceNearest(uint slice, Ray ray, float t_min, float t_max) {
  return traceExcept(slice, RAYS_TO_ALL, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE);
}

// True if the ray meets a surface with t in (t_min, t_max). Both sides of a surface count, because both cast shadows.
bool isBlocked(uint slice, Ray ray, float t_min, float t_max) {
  ++launched_rays;
  return launch(slice, RAYS_TO_ALL, true, true, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE).instance != NO_INSTANCE;
}

// True if the ray meets a surface with t in (t_min, t_max). One-sided surfaces count only if the ray meets their front. `mask`
// as in `traceExcept`.
bool isHidden(uint slice, uint mask, Ray ray, float t_min, float t_max) {
  ++launched_rays;
  return launch(slice, mask, true, false, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE).instance != NO_INSTANCE;
}

#endif
