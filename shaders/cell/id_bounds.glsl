// SPDX-License-Identifier: MIT
// Per cell (a square of `cell_side` px), the least and the greatest instance number that its pixels show. If both are equal,
// the cell contains no silhouette between instances, and later passes can skip it.
// In:  `id`: instance + 1; 0 for the sky.
// Out: `ids`: least and greatest instance + 1 (0 for the sky); both are equal if the cell shows one instance.
// Method: minimum and maximum over the cell. Cells at the right and bottom border may be partial.
// Fails: never.

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
