// SPDX-License-Identifier: MIT
// Per cell, the least and the greatest instance seen in it.
// In:  id (instance + 1, 0 = sky).  Out: ids (least, greatest). The last cells may be partial.

void run(ivec2 cell) {
  ivec2 first = cell * params.cell_side;
  ivec2 end = min(first + params.cell_side, textureSize(id_tex, 0));
  uint least = 0xffffffffu, greatest = 0u;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      uint id = texelFetch(id_tex, ivec2(x, y), 0).x;
      least = min(least, id);
      greatest = max(greatest, id);
    }
  }
  imageStore(ids_img, cell, uvec4(least, greatest, 0u, 0u));
}
