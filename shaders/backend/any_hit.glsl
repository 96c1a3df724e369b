// SPDX-License-Identifier: MIT
// Ray tracing pipeline: refuses hits on what the ray skips, on cut-out texels and on backs that it does not see.
#include "mixin/trace_payload.glsl"
layout(location = 0) rayPayloadInEXT TracePayload payload;
hitAttributeEXT vec2 barycentrics;
void main() {
  bool unseen = false;
#if FACT_one_sided
  bool sees_fronts = (gl_IncomingRayFlagsEXT & gl_RayFlagsCullBackFacingTrianglesEXT) != 0u;
  unseen = sees_fronts && gl_HitKindEXT != gl_HitKindFrontFacingTriangleEXT;
#endif
  if (!acceptsHit(uint(gl_InstanceID), uint(gl_GeometryIndexEXT), uint(gl_PrimitiveID), barycentrics,
                  payload.skip_instance, payload.skip_geometry, unseen))
    ignoreIntersectionEXT;
}
