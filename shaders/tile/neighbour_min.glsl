// SPDX-License-Identifier: MIT
// Per tile, the length of the shortest displacement in the tiles around it (Guertin et al. 2014; Jimenez 2014). Filters treat
// the motion as uniform if this length is nearly the length of the dominant displacement.
// In:  `shortest`: length of the shortest displacement of each tile, px over the exposure.
// Out: `slowest`: least value of `shortest` in the tiles around, px over the exposure.
// Method: minimum over all tiles as far away as a displacement of the largest length (`limit`) can reach, as in
//   tile/neighbour_max.glsl. Every tile counts, because a surface that does not reach this tile may still lie on the path of a
//   tap.
// Fails: one static pixel makes the whole neighbourhood count as static.
#include "mixin/limit.glsl"

void run(ivec2 tile) {
  ivec2 size = textureSize(shortest_tex, 0);
  int radius = tilesInReach(reachPx(), params.tile, frame.shutter, size);
  ivec2 first = max(tile - radius, ivec2(0));
  ivec2 last = min(tile + radius, size - 1);
  float slowest = texelFetch(shortest_tex, tile, 0).x;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) slowest = min(slowest, texelFetch(shortest_tex, ivec2(x, y), 0).x);
  }
  imageStore(slowest_img, tile, vec4(slowest, 0, 0, 0));
}
