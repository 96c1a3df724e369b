// SPDX-License-Identifier: MIT
// Needs: rays.
// Tracing backend `query`: Vulkan ray queries, in compute shaders.

// Trace one ray, for the functions of mixin/trace.glsl. Slice, interval and skipped instance are as in `traceExcept`. `mask`:
// RAYS_TO_*. `any_hit`: return any hit in the interval (the first one found) instead of the nearest. `both_sides`: one-sided
// surfaces count from behind too. A miss has the instance NO_INSTANCE.
TraceResult launch(uint slice, uint mask, bool any_hit, bool both_sides, Ray ray, float t_min, float t_max,
                   uint skip_instance,
                   uint skip_geometry) {
  uint flags = any_hit ? gl_RayFlagsTerminateOnFirstHitEXT : gl_RayFlagsNoneEXT;
  if (skip_instance != NO_INSTANCE) flags |= gl_RayFlagsNoOpaqueEXT;
#if FACT_one_sided
  if (!both_sides) flags |= gl_RayFlagsCullBackFacingTrianglesEXT;
#endif
  rayQueryEXT query;
  rayQueryInitializeEXT(query, scene_top_levels[nonuniformEXT(slice)], flags, mask, ray.origin, t_min, ray.direction, t_max);
  while (rayQueryProceedEXT(query)) {
    if (rayQueryGetIntersectionTypeEXT(query, false) != gl_RayQueryCandidateIntersectionTriangleEXT) continue;
    uint instance = uint(rayQueryGetIntersectionInstanceIdEXT(query, false));
    uint geometry = uint(rayQueryGetIntersectionGeometryIndexEXT(query, false));
    uint primitive = uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, false));
    vec2 barycentrics = rayQueryGetIntersectionBarycentricsEXT(query, false);
#if FACT_one_sided
    bool is_back_face = !both_sides && !rayQueryGetIntersectionFrontFaceEXT(query, false);
#else
    bool is_back_face = false;
#endif
    if (acceptsHit(instance, geometry, primitive, barycentrics, skip_instance, skip_geometry, is_back_face))
      rayQueryConfirmIntersectionEXT(query);
  }
  TraceResult found = TraceResult(NO_INSTANCE, 0u, 0u, vec2(0), 0.0);
  if (rayQueryGetIntersectionTypeEXT(query, true) != gl_RayQueryCommittedIntersectionTriangleEXT) return found;
  found.instance = uint(rayQueryGetIntersectionInstanceIdEXT(query, true));
  found.geometry = uint(rayQueryGetIntersectionGeometryIndexEXT(query, true));
  found.primitive = uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, true));
  found.barycentrics = rayQueryGetIntersectionBarycentricsEXT(query, true);
  found.t = rayQueryGetIntersectionTEXT(query, true);
  return found;
}
