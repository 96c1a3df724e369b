// SPDX-License-Identifier: MIT
// The composite `layered` with the additional output guess, a fallback estimate of unresolved samples.
// In, Out, Method, Fails: see layered/layered_composite.glsl.
#define WRITES_ESTIMATE
#include "layered/layered_composite.glsl"
