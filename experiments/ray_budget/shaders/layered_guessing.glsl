// SPDX-License-Identifier: MIT
// The composite `layered`, which also guesses what it leaves open.
// In, Out, Fails: as layered.glsl.
#define GUESSES
#include "composite/layered.glsl"
