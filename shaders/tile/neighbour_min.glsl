// SPDX-License-Identifier: MIT
// Per tile, the shortest of the displacements around it (Guertin et al. 2014; Jimenez 2014).
// In:  shortest (px over the exposure, per tile).
// Out: slowest (px over the exposure). Tiles as far away as for the dominant displacement (neighbour_max.glsl) are
//   asked, and each of them counts: what does not move over this tile may still be met along the way.
// Fails: one pixel at rest makes the whole neighbourhood slow.
#include "mixin/limit.glsl"

void run(ivec2 pixel) {
  ivec2 size = textureSize(shortest_tex, 0);
  int radius = tilesInReach(reachPx(), params.tile, frame.shutter, size);
  ivec2 first = max(pixel - radius, ivec2(0));
  ivec2 last = min(pixel + radius, size - 1);
  float slowest = texelFetch(shortest_tex, pixel, 0).x;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) slowest = min(slowest, texelFetch(shortest_tex, ivec2(x, y), 0).x);
  }
  imageStore(slowest_img, pixel, vec4(slowest, 0, 0, 0));
}
