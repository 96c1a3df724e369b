// SPDX-License-Identifier: MIT
// Needs: rays, scene; may have: PARAM_displacement.
// Rays. One interface over the tracing backends: the runtime compiles the same pass as a ray generation shader
// (STROBE_BACKEND_PIPELINE) or as a compute shader with ray queries (STROBE_BACKEND_QUERY); both find the same hits.
// A ray interval is open at both ends: a hit at exactly t_min or t_max is not found.
#ifndef STROBE_TRACE_GLSL
#define STROBE_TRACE_GLSL
#include "mixin/surface.glsl"
#include "mixin/trace_payload.glsl"

// Rays this invocation has launched; the runtime adds them to the pass's counter of its backend.
uint launched_rays = 0u;

#if defined(STROBE_BACKEND_PIPELINE)
layout(location = 0) rayPayloadEXT TracePayload trace_payload;

void launch(uint slice, uint flags, Ray ray, float t_min, float t_max, uint skip_instance, uint skip_geometry) {
  trace_payload = TracePayload(NO_INSTANCE, 0u, 0u, vec2(0), 0.0, skip_instance, skip_geometry);
  // A ray that stops at its first hit runs no closest-hit shader: it counts as blocked unless the miss shader says so.
  bool any_hit_ends = (flags & gl_RayFlagsSkipClosestHitShaderEXT) != 0u;
  if (any_hit_ends) trace_payload.instance = 0u;
  traceRayEXT(scene_top_levels[nonuniformEXT(slice)], flags, 0xff, 0, 0, 0, ray.origin, t_min, ray.direction, t_max, 0);
}
#else
struct TraceResult {
  uint instance, geometry, primitive;
  vec2 barycentrics;
  float t;
};
TraceResult trace_payload;

void launch(uint slice, uint flags, Ray ray, float t_min, float t_max, uint skip_instance, uint skip_geometry) {
  rayQueryEXT query;
  rayQueryInitializeEXT(query, scene_top_levels[nonuniformEXT(slice)], flags, 0xff, ray.origin, t_min, ray.direction, t_max);
  while (rayQueryProceedEXT(query)) {
    if (rayQueryGetIntersectionTypeEXT(query, false) != gl_RayQueryCandidateIntersectionTriangleEXT) continue;
    uint instance = uint(rayQueryGetIntersectionInstanceIdEXT(query, false));
    uint geometry = uint(rayQueryGetIntersectionGeometryIndexEXT(query, false));
    uint primitive = uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, false));
    vec2 barycentrics = rayQueryGetIntersectionBarycentricsEXT(query, false);
    if (acceptsHit(instance, geometry, primitive, barycentrics, skip_instance, skip_geometry))
      rayQueryConfirmIntersectionEXT(query);
  }
  trace_payload.instance = NO_INSTANCE;
  if (rayQueryGetIntersectionTypeEXT(query, true) != gl_RayQueryCommittedIntersectionTriangleEXT) return;
  trace_payload.instance = uint(rayQueryGetIntersectionInstanceIdEXT(query, true));
  trace_payload.geometry = uint(rayQueryGetIntersectionGeometryIndexEXT(query, true));
  trace_payload.primitive = uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, true));
  trace_payload.barycentrics = rayQueryGetIntersectionBarycentricsEXT(query, true);
  trace_payload.t = rayQueryGetIntersectionTEXT(query, true);
}
#endif

// Is the triangle seen from its front by this ray?
bool seenFromFront(uint slice, Ray ray, uint instance, uint geometry, uint primitive) {
  Triangle triangle = triangleOf(geometryOf(instance, geometry), primitive);
  vec3 a = scene_vertices[triangle.index[0]].position;
  vec3 face_os = cross(scene_vertices[triangle.index[1]].position - a, scene_vertices[triangle.index[2]].position - a);
  return dot(normalFromObject(transformOf(slice, instance), face_os), ray.direction) < 0.0;
}

// The nearest hit with t in (t_min, t_max) on anything but `skip_instance` (NO_INSTANCE skips nothing); where
// `skip_geometry` is not NO_INSTANCE only that geometry of the instance is skipped. A miss has instance NO_INSTANCE.
Hit traceExcept(uint slice, Ray ray, float t_min, float t_max, uint skip_instance, uint skip_geometry) {
  ++launched_rays;
  uint flags = skip_instance == NO_INSTANCE ? gl_RayFlagsNoneEXT : gl_RayFlagsNoOpaqueEXT;
  launch(slice, flags, ray, t_min, t_max, skip_instance, skip_geometry);
  if (trace_payload.instance == NO_INSTANCE) return noHit();
  Hit hit = Hit(trace_payload.instance, trace_payload.geometry, trace_payload.primitive, trace_payload.barycentrics,
                trace_payload.t, true);
  hit.front = seenFromFront(slice, ray, hit.instance, hit.geometry, hit.primitive);
  return hit;
}

Hit traceNearest(uint slice, Ray ray, float t_min, float t_max) {
  return traceExcept(slice, ray, t_min, t_max, NO_INSTANCE, NO_INSTANCE);
}

// Does anything lie on the ray with t in (t_min, t_max)?
bool isBlocked(uint slice, Ray ray, float t_min, float t_max) {
  ++launched_rays;
  launch(slice, gl_RayFlagsTerminateOnFirstHitEXT | gl_RayFlagsSkipClosestHitShaderEXT, ray, t_min, t_max, NO_INSTANCE,
         NO_INSTANCE);
  return trace_payload.instance != NO_INSTANCE;
}

#endif
