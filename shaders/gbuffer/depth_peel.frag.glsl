// SPDX-License-Identifier: MIT
// One step of depth peeling, fragment stage: the nearest surface behind the layer in front (Everitt, "Interactive
// Order-Independent Transparency", 2001).
// In:  `front`: layer in front: instance + 1 (0 for the sky), geometry, primitive.
// Out: `hit`: nearest surface behind that layer: instance + 1 (0 for the sky), geometry, primitive; 0 also where
//        `front` is the sky.
// Method: discard fragments that are not behind `front`; the depth test keeps the nearest of the others. One function
//   computes the depths of both triangles at the pixel's sample position, so the comparison needs no bias. At equal
//   depths the triangle that is drawn later counts as the one behind, as in the depth test. With `sides` = front, back
//   faces are discarded too.
// Fails: if two surfaces are closer together than the depth buffer resolves, the depth test may order them differently
//   than this comparison does. One of the two surfaces is then in no layer.
#include "mixin/fragment.glsl"
#include "mixin/surface.glsl"

// True if triangle a is drawn after triangle b. Triangles: instance + 1, geometry, primitive.
bool isLater(uvec3 triangle_a, uvec3 triangle_b) {
  if (triangle_a.x != triangle_b.x) return triangle_a.x > triangle_b.x;
  return triangle_a.y != triangle_b.y ? triangle_a.y > triangle_b.y : triangle_a.z > triangle_b.z;
}

// True if the fragment is behind the surface of `front` at its pixel.
bool isBackground(ivec2 pixel) {
  uvec4 front = texelFetch(front_tex, pixel, 0);
  if (front.x == 0u) return false;
  uvec3 own = uvec3(draw.x + 1u, draw.y, triangle);
  if (own == front.xyz) return false;
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  float front_t = hitOnTriangle(TIME_SLICE, ray, front.x - 1u, front.y, front.z).t;
  Hit hit = hitOnTriangle(TIME_SLICE, ray, draw.x, draw.y, triangle);
#if PARAM_sides == sides_front
  if (!hit.front) return false;
#endif
  return hit.t > front_t || (hit.t == front_t && isLater(own, front.xyz));
}

void main() {
  count_fragments(1u);
  if (isLeftOut() || !isBackground(ivec2(gl_FragCoord.xy))) discard;
  hit_out = uvec4(draw.x + 1u, draw.y, triangle, 0u);
}
