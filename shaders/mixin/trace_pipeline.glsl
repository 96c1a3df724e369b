// SPDX-License-Identifier: MIT
// Needs: rays.
// Tracing backend `pipeline`: ray tracing pipelines of Vulkan. The miss, any-hit and closest-hit stages are in
// shaders/backend/.
layout(location = 0) rayPayloadEXT TracePayload trace_payload;

// Trace one ray, for the functions of mixin/trace.glsl. Slice, interval and skipped instance are as in `traceExcept`. `mask`:
// RAYS_TO_*. `any_hit`: return any hit in the interval (the first one found) instead of the nearest. `both_sides`: one-sided
// surfaces count from behind too. A miss has the instance NO_INSTANCE.
TraceResult launch(uint slice, uint mask, bool any_hit, bool both_sides, Ray ray, float t_min, float t_max,
                   uint skip_instance,
                   uint skip_geometry) {
  uint flags = skip_instance == NO_INSTANCE ? gl_RayFlagsNoneEXT : gl_RayFlagsNoOpaqueEXT;
#if FACT_one_sided
  if (!both_sides) flags |= gl_RayFlagsCullBackFacingTrianglesEXT;
#endif
  trace_payload = TracePayload(NO_INSTANCE, 0u, 0u, vec2(0), 0.0, skip_instance, skip_geometry);
  if (any_hit) {
    // A ray that stops at its first hit runs no closest-hit shader, which would store the hit. Store a hit in advance; the miss
    // shader resets it to NO_INSTANCE.
    flags |= gl_RayFlagsTerminateOnFirstHitEXT | gl_RayFlagsSkipClosestHitShaderEXT;
    trace_payload.instance = 0u;
  }
  traceRayEXT(scene_top_levels[nonuniformEXT(slice)], flags, mask, 0, 0, 0, ray.origin, t_min, ray.direction, t_max, 0);
  return TraceResult(trace_payload.instance, trace_payload.geometry, trace_payload.primitive,
                     trace_payload.barycentrics, trace_payload.t);
}
