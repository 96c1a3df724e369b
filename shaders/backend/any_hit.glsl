// SPDX-License-Identifier: MIT
// Ray tracing pipeline: refuses hits on what the ray skips and on cut-out texels.
#include "mixin/trace_payload.glsl"
layout(location = 0) rayPayloadInEXT TracePayload payload;
hitAttributeEXT vec2 barycentrics;
void main() {
  if (!acceptsHit(uint(gl_InstanceID), uint(gl_GeometryIndexEXT), uint(gl_PrimitiveID), barycentrics,
                  payload.skip_instance, payload.skip_geometry))
    ignoreIntersectionEXT;
}
