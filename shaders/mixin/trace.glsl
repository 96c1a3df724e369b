// SPDX-License-Identifier: MIT
// Needs: rays, scene; may have: PARAM_displacement.
// Ray tracing: one interface over the tracing backends (listed in runtime/shader/backends.h), which find equal hits.
// The interval (t_min, t_max) of a ray is open: a hit at exactly t_min (0 or more) or exactly t_max is not found. Rays pass
// through one-sided surfaces from behind. Only the rays of `isBlocked` hit both sides. Rays can be traced at the raster time
// and at the sample times of a loop (SLICE_RASTER, SLICE_SAMPLE and later slices).
#ifndef STROBE_TRACE_GLSL
#define STROBE_TRACE_GLSL
#include "mixin/surface.glsl"
#include "mixin/trace_payload.glsl"

// Number of rays that this invocation traced. The runtime adds the number to the pass's counter for the backend.
uint launched_rays = 0u;

// Hit as a backend returns it.
struct TraceResult {
  uint instance, geometry, primitive;  // instance NO_INSTANCE: a miss
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

// True if the ray meets the front of a triangle that it hits, with the scene posed at `slice`.
bool isFrontFacing(uint slice, Ray ray, uint instance, uint geometry, uint primitive) {
  Triangle triangle = triangleOf(geometryOf(instance, geometry), primitive);
  vec3 a = vertexPosition(slice, triangle.vertex[0]);
  vec3 face_os = cross(vertexPosition(slice, triangle.vertex[1]) - a, vertexPosition(slice, triangle.vertex[2]) - a);
  return dot(normalFromObject(transformOf(slice, instance), face_os), ray.direction) < 0.0;
}

// Nearest hit with t in (t_min, t_max), with the scene posed at `slice`. A miss has the instance NO_INSTANCE. `mask`:
// RAYS_TO_ALL, or RAYS_TO_MOVING to test only the instances that may move within the exposure. The ray skips hits on the
// instance `skip_instance` (NO_INSTANCE: skip nothing). If `skip_geometry` is not NO_INSTANCE, the ray skips only this geometry
// of the instance.
Hit traceExcept(uint slice, uint mask, Ray ray, float t_min, float t_max, uint skip_instance, uint skip_geometry) {
  ++launched_rays;
  TraceResult found = launch(slice, mask, false, false, ray, t_min, t_max, skip_instance, skip_geometry);
  if (found.instance == NO_INSTANCE) return noHit();
  Hit hit = Hit(found.instance, found.geometry, found.primitive, found.barycentrics, found.t, true);
  hit.front = isFrontFacing(slice, ray, hit.instance, hit.geometry, hit.primitive);
  return hit;
}

// Nearest hit on `instance`, for callers that ignore hits on other instances. The backend `bvh` tests this instance alone, so
// it may return a hit that another instance occludes. The other backends test all instances and may return a hit on another
// instance.
Hit traceInstance(uint slice, uint instance, Ray ray, float t_min, float t_max) {
#ifdef STROBE_BACKEND_BVH
  uint mask = RAYS_TO_ONE + instance;
#else
  uint mask = RAYS_TO_ALL;
#endif
  return traceExcept(slice, mask, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE);
}

// Nearest hit with t in (t_min, t_max) on any instance; a miss has the instance NO_INSTANCE.
Hit traceNearest(uint slice, Ray ray, float t_min, float t_max) {
  return traceExcept(slice, RAYS_TO_ALL, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE);
}

// Shadow test: true if the ray meets a surface with t in (t_min, t_max). Both sides of a surface count, because both cast
// shadows.
bool isBlocked(uint slice, Ray ray, float t_min, float t_max) {
  ++launched_rays;
  return launch(slice, RAYS_TO_ALL, true, true, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE).instance != NO_INSTANCE;
}

// Occlusion test: true if the ray meets a visible surface with t in (t_min, t_max). One-sided surfaces count only if the ray
// meets their front. `mask`: as in `traceExcept`.
bool isHidden(uint slice, uint mask, Ray ray, float t_min, float t_max) {
  ++launched_rays;
  return launch(slice, mask, true, false, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE).instance != NO_INSTANCE;
}

#endif
