// SPDX-License-Identifier: MIT
// Nearest triangle at each pixel's sample position, fragment stage.
// In:  fragments of gbuffer/visibility.vert.glsl: instance, geometry, triangle, texture coordinates, vertex alpha
// Out: `hit`: instance + 1 (0 = sky), geometry, primitive, 0
// Method: the depth test keeps the nearest fragment. Fragments that alpha leaves out, and backs of one-sided surfaces, are
//      discarded by the tests that rays use (mixin/fragment.glsl).
// Fails: raster snaps vertices to 1/256 px, so silhouettes may differ from the hits of rays.
#include "mixin/fragment.glsl"

void main() {
  if (isLeftOut()) discard;
  hit_out = uvec4(draw.x + 1u, draw.y, triangle, 0u);
}
