// SPDX-License-Identifier: MIT
// Vertices of a peeled layer, computed as for the nearest surface.
// In:  as gbuffer/visibility.vert.glsl
// Out: as gbuffer/visibility.vert.glsl
// Method: includes that shader.
// Fails: never.
#include "gbuffer/visibility.vert.glsl"
