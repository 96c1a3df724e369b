// SPDX-License-Identifier: MIT
// Needs: rays, scene; may have: PARAM_displacement.
// Rays. One interface over the tracing backends, which find the same hits (runtime/shader/backends.h lists them).
// A ray interval is open at both ends: a hit at exactly t_min, which is 0 or more, or at t_max is not found.
// What is seen from one side alone is not there for rays that meet it from behind, but for those of `isBlocked`.
#ifndef STROBE_TRACE_GLSL
#define STROBE_TRACE_GLSL
#include "mixin/surface.glsl"
#include "mixin/trace_payload.glsl"

// Rays this invocation has launched; the runtime adds them to the pass's counter of its backend.
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

// Is the triangle seen from its front by this ray?
bool seenFromFront(uint slice, Ray ray, uint instance, uint geometry, uint primitive) {
  Triangle triangle = triangleOf(geometryOf(instance, geometry), primitive);
  vec3 a = vertexPosition(slice, triangle.vertex[0]);
  vec3 face_os = cross(vertexPosition(slice, triangle.vertex[1]) - a, vertexPosition(slice, triangle.vertex[2]) - a);
  return dot(normalFromObject(transformOf(slice, instance), face_os), ray.direction) < 0.0;
}

// The nearest hit with t in (t_min, t_max) on anything but `skip_instance` (NO_INSTANCE skips nothing); where
// `skip_geometry` is not NO_INSTANCE only that geometry of the instance is skipped. A miss has instance NO_INSTANCE.
// `mask`: RAYS_TO_ALL, or RAYS_TO_MOVING for what may move within the exposure alone.
Hit traceExcept(uint slice, uint mask, Ray ray, float t_min, float t_max, uint skip_instance, uint skip_geometry) {
  ++launched_rays;
  TraceResult found = launch(slice, mask, false, false, ray, t_min, t_max, skip_instance, skip_geometry);
  if (found.instance == NO_INSTANCE) return noHit();
  Hit hit = Hit(found.instance, found.geometry, found.primitive, found.barycentrics, found.t, true);
  hit.front = seenFromFront(slice, ray, hit.instance, hit.geometry, hit.primitive);
  return hit;
}

// The nearest hit where that is one of `instance`, which backend `bvh` asks alone; the others ask all.
Hit traceInstance(uint slice, uint instance, Ray ray, float t_min, float t_max) {
#ifdef STROBE_BACKEND_BVH
  uint mask = RAYS_TO_ONE + instance;
#else
  uint mask = RAYS_TO_ALL;
#endif
  return traceExcept(slice, mask, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE);
}

Hit traceNearest(uint slice, Ray ray, float t_min, float t_max) {
  return traceExcept(slice, RAYS_TO_ALL, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE);
}

// Does anything lie on the ray with t in (t_min, t_max), whichever side it turns there? Surfaces cast shadows with both.
bool isBlocked(uint slice, Ray ray, float t_min, float t_max) {
  ++launched_rays;
  return launch(slice, RAYS_TO_ALL, true, true, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE).instance != NO_INSTANCE;
}

// Would anything be seen on the ray with t in (t_min, t_max)? `mask` as above.
bool isHidden(uint slice, uint mask, Ray ray, float t_min, float t_max) {
  ++launched_rays;
  return launch(slice, mask, true, false, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE).instance != NO_INSTANCE;
}

#endif
