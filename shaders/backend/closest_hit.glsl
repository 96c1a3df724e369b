// SPDX-License-Identifier: MIT
// Closest-hit stage of the ray tracing pipeline: stores the nearest accepted hit.
// In:  the hit, as built-in variables and barycentrics.
// Out: `payload`: instance, geometry, primitive, barycentrics and ray parameter t of the hit (mixin/trace_payload.glsl).
// Method: copy the built-in variables. The shader that traced the ray does the shading.
// Fails: never.
#include "mixin/trace_payload.glsl"
layout(location = 0) rayPayloadInEXT TracePayload payload;
hitAttributeEXT vec2 barycentrics;
void main() {
  payload.instance = uint(gl_InstanceID);
  payload.geometry = uint(gl_GeometryIndexEXT);
  payload.primitive = uint(gl_PrimitiveID);
  payload.barycentrics = barycentrics;
  payload.t = gl_HitTEXT;
}
