// SPDX-License-Identifier: MIT
// The composite `layered` with the additional output fallback_estimate, a fallback estimate of the unresolved samples.
// In, Out, Method, Fails: see layered/layered_composite.glsl.
#define WRITES_ESTIMATE
#include "layered/layered_composite.glsl"
