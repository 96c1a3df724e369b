// SPDX-License-Identifier: MIT
// One step of depth peeling: the nearest surface behind a layer (Everitt, "Interactive Order-Independent Transparency", 2001).
// In:  `front`: instance + 1 (0 = sky), geometry, primitive of the layer in front
// Out: `hit`:   instance + 1 (0 = sky), geometry, primitive of the nearest surface behind; sky behind the sky
// Method: discard fragments that are not behind `front`. One function computes both depths, at the pixel's sample position on
//      their triangles, so the comparison needs no bias. At equal depths the triangle drawn later is behind, as in the depth
//      test. With `sides` = front, hits on backs are discarded too.
// Fails: two surfaces closer together than the depth buffer resolves, if it orders them differently than this comparison does:
//      one of the two is in no layer.
#include "mixin/fragment.glsl"
#include "mixin/surface.glsl"

bool isLater(uvec3 triangle_a, uvec3 triangle_b) {
  if (triangle_a.x != triangle_b.x) return triangle_a.x > triangle_b.x;
  return triangle_a.y != triangle_b.y ? triangle_a.y > triangle_b.y : triangle_a.z > triangle_b.z;
}

bool isBackground(ivec2 pixel) {
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
  if (isLeftOut() || !isBackground(ivec2(gl_FragCoord.xy))) discard;
  hit_out = uvec4(draw.x + 1u, draw.y, triangle, 0u);
}
