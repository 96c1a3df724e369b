// SPDX-License-Identifier: MIT
// The composite `layered` with the further output fallback_estimate: a colour for the time samples that no layer resolves, for
// pixels without rays.
// In, Out, Method, Fails: see layered/layered_composite.glsl.
#define WRITES_ESTIMATE
#include "layered/layered_composite.glsl"
