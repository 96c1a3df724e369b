// SPDX-License-Identifier: MIT
// Any-hit stage of the ray tracing pipeline: rejects hits that do not count.
// In:  `payload`: instance and geometry that the ray skips (mixin/trace_payload.glsl).
// Out: none; a rejected hit is ignored, and the traversal goes on.
// Method: reject hits on the skipped instance or geometry, hits on points that alpha cuts out, and, for rays that cull back
//   faces, hits on the back of one-sided materials. `acceptsHit` has the tests that all backends share.
// Fails: never.
#include "mixin/trace_payload.glsl"
layout(location = 0) rayPayloadInEXT TracePayload payload;
hitAttributeEXT vec2 barycentrics;
void main() {
  bool is_back_face = false;
#if FACT_one_sided
  bool sees_fronts = (gl_IncomingRayFlagsEXT & gl_RayFlagsCullBackFacingTrianglesEXT) != 0u;
  is_back_face = sees_fronts && gl_HitKindEXT != gl_HitKindFrontFacingTriangleEXT;
#endif
  if (!acceptsHit(uint(gl_InstanceID), uint(gl_GeometryIndexEXT), uint(gl_PrimitiveID), barycentrics,
                  payload.skip_instance, payload.skip_geometry, is_back_face))
    ignoreIntersectionEXT;
}
