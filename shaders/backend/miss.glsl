// SPDX-License-Identifier: MIT
// Miss stage of the ray tracing pipeline: stores that the ray hit nothing.
// In:  none.
// Out: `payload`: the instance number that means no hit (mixin/trace_payload.glsl).
// Method: write the instance; other fields keep their values.
// Fails: never.
#include "mixin/trace_payload.glsl"
layout(location = 0) rayPayloadInEXT TracePayload payload;
void main() { payload.instance = NO_INSTANCE; }
