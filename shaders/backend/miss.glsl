// SPDX-License-Identifier: MIT
// Miss stage of the ray tracing pipeline: stores that the ray hit nothing.
#include "mixin/trace_payload.glsl"
layout(location = 0) rayPayloadInEXT TracePayload payload;
void main() { payload.instance = NO_INSTANCE; }
