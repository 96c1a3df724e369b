// SPDX-License-Identifier: MIT
// Closest-hit stage of the ray tracing pipeline: stores the nearest accepted hit. Shading happens elsewhere.
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
