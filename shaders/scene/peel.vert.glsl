// SPDX-License-Identifier: MIT
// Vertices of a peeled layer, computed as for the nearest surface.
// In:  as scene/visibility.vert.glsl
// Out: as scene/visibility.vert.glsl
// Method: includes that shader.
// Fails: never.
#include "scene/visibility.vert.glsl"
