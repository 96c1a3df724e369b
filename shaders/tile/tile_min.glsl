// SPDX-License-Identifier: MIT
// Per tile, the length of the shortest displacement in it (Guertin et al. 2014; Jimenez 2014).
// In:  `velocity`: px over the exposure
//      `valid`:    above 1/2 where the texel counts; absent: all count
// Out: `shortest`: px over the exposure, at most `limit` image widths; exactly the limit if no texel counts
// Method: minimum over the tile, by a work group. Tiles at the right and bottom border may be partial.
// Fails: directions are not compared: a rotating tile looks as uniform as a translating one.
#include "mixin/limit.glsl"
#include "lib/group.glsl"
#include "lib/sanitise.glsl"

shared uint shortest_bits;  // bits of a float of at least 0, which have the order of the floats

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
