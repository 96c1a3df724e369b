// SPDX-License-Identifier: MIT
// The nearest of what lies behind what is known: one step of depth peeling (Everitt, "Interactive Order-Independent
// Transparency", 2001).
// In:  front (instance + 1, geometry, primitive; 0 = sky) of the layer in front.
// Out: hit, the same of the nearest behind it; sky behind sky.
// Both depths are those of triangles at the pixel's sample position, computed by one function: no bias. Of equal ones the
// later in the order of drawing is behind, as the depth test has it.
// Fails: where raster's own depths order two surfaces otherwise than these, closer together than its numbers tell apart,
//   one of them is in no layer.
#include "mixin/fragment.glsl"
#include "mixin/surface.glsl"

bool isLater(uvec3 triangle_a, uvec3 triangle_b) {
  if (triangle_a.x != triangle_b.x) return triangle_a.x > triangle_b.x;
  return triangle_a.y != triangle_b.y ? triangle_a.y > triangle_b.y : triangle_a.z > triangle_b.z;
}

bool isBehind(ivec2 pixel) {
  uvec4 front = texelFetch(front_tex, pixel, 0);
  if (front.x == 0u) return false;
  uvec3 own = uvec3(draw.x + 1u, draw.y, triangle);
  if (own == front.xyz) return false;
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  float known = hitOnTriangle(TIME_SLICE, ray, front.x - 1u, front.y, front.z).t;
  Hit hit = hitOnTriangle(TIME_SLICE, ray, draw.x, draw.y, triangle);
#if PARAM_sides == sides_front
  if (!hit.front) return false;
#endif
  return hit.t > known || (hit.t == known && isLater(own, front.xyz));
}

void main() {
  count_fragments(1u);
  if (isLeftOut() || !isBehind(ivec2(gl_FragCoord.xy))) discard;
  hit_out = uvec4(draw.x + 1u, draw.y, triangle, 0u);
}
