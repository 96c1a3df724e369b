// SPDX-License-Identifier: MIT
// One step of depth peeling, vertex stage: transforms vertices exactly as for the first layer, so that depths agree.
// In:  vertices of the scene, as in gbuffer/visibility.vert.glsl.
// Out: clip position and attributes, as in gbuffer/visibility.vert.glsl.
// Method: include gbuffer/visibility.vert.glsl.
// Fails: never.
#include "gbuffer/visibility.vert.glsl"
