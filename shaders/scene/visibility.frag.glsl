// SPDX-License-Identifier: MIT
// Output: hit = (instance + 1, geometry, primitive, 0). Discards by the same tests as rays use what alpha leaves out, and
// backs of what is seen from one side alone.
#include "mixin/fragment.glsl"

void main() {
  if (isLeftOut()) discard;
  hit_out = uvec4(draw.x + 1u, draw.y, triangle, 0u);
}
