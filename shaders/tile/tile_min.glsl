// SPDX-License-Identifier: MIT
// Per tile, the length of the shortest displacement of its texels (Guertin et al. 2014; Jimenez 2014). Filters compare this
// length with the dominant displacement, to find uniform motion.
// In:  `velocity`: displacement of the surface at each texel, px over the exposure.
//      `valid`: mask, above 1/2 at texels to include (absent: all texels).
// Out: `shortest`: length of the shortest displacement, px over the exposure, at most `limit` image widths; equal to the limit
//        if no texel is included.
// Method: one work group takes the minimum over the tile's texels. Tiles at the right and bottom border may be partial.
// Fails: lengths are compared, not directions, so that a rotating tile counts as uniform, like a translating tile.
#include "mixin/limit.glsl"
#include "lib/group.glsl"
#include "lib/sanitise.glsl"

// Length of the shortest displacement of the tile, as the bits of a float. Floats of at least 0 have the order of their bits.
shared uint shortest_bits;

void run(ivec2 tile) {
  bool is_first = gl_LocalInvocationIndex == 0u;
  if (is_first) shortest_bits = floatBitsToUint(limitPx());
  barrier();
  ivec2 first = tile * params.tile;
  ivec2 end = min(first + params.tile, textureSize(velocity_tex, 0));
  float shortest = limitPx();
  ivec2 own = ownFirst(first);
  for (int y = own.y; y < end.y; y += kGroupSide) {
    for (int x = own.x; x < end.x; x += kGroupSide) {
      if (valid_at(ivec2(x, y)).x <= 0.5) continue;
      shortest = min(shortest, lengthOf(finiteDisplacement(velocity_at(ivec2(x, y)))));
    }
  }
  atomicMin(shortest_bits, floatBitsToUint(shortest));
  barrier();
  if (is_first) imageStore(shortest_img, tile, vec4(uintBitsToFloat(shortest_bits), 0, 0, 0));
}
