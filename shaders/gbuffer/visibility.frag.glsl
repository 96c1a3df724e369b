// SPDX-License-Identifier: MIT
// Nearest triangle at each pixel's sample position, fragment stage.
// In:  fragments of the triangles drawn by gbuffer/visibility.vert.glsl: instance, geometry, triangle; if needed, also texture
//      coordinates, vertex alpha and mirroring.
// Out: `hit`: instance + 1 (0 for the sky), geometry, primitive, 0.
// Method: the depth test keeps the nearest fragment. Fragments that alpha cuts out, and back faces of one-sided materials, are
//   discarded by the tests that rays also use (mixin/fragment.glsl).
// Fails: rasterisation snaps vertices to 1/256 px, so silhouettes may differ from the hits of rays.
#include "mixin/fragment.glsl"

void main() {
  if (isLeftOut()) discard;
  hit_out = uvec4(draw.x + 1u, draw.y, triangle, 0u);
}
