// SPDX-License-Identifier: MIT
// Ray tracing pipeline: nothing was hit.
#include "mixin/trace_payload.glsl"
layout(location = 0) rayPayloadInEXT TracePayload payload;
void main() { payload.instance = NO_INSTANCE; }
