// SPDX-License-Identifier: MIT
// Cells where every surface moves and a gather is not reliable.
// In:  `bounds`: bounds of the displacements in each cell, px over the exposure
//      `certain`, `longest`: outputs of time/coherent_cells.glsl
// Out: `drawn`: x: 1 where images rasterised at several times are averaged, otherwise 0; y: 1
//      `untraced`: 1 where a gather is reliable, 1/2 where nothing moves or images are averaged, 0 where rays are
//        traced
//      `first_ray`: displacement that the times of the first rays depend on, px over the exposure
// Method: a gather is not reliable in cells with `certain` < 0.4, and beside cells that a ray refuted (`certain` =
//   1/4), as in time/adaptive_times.glsl. Of these cells, images are averaged where no displacement within `bounds` is
//   static. With a static camera no images are averaged: nearly all cells have a static surface, and each image would
//   be drawn for a few cells.
// Fails: bounds of opposite displacements contain 0, so that the cell is traced although everything moves.
#include "lib/bounds.glsl"

void run(ivec2 cell) {
  float certain = texelFetch(certain_tex, cell, 0).x;
  vec4 longest = texelFetch(longest_tex, cell, 0);
  for (int k = 0; k < 9 && certain > 0.4; ++k) {
    ivec2 at = clampToImage(cell + ivec2(k % 3, k / 3) - 1, pass_size());
    float other = texelFetch(certain_tex, at, 0).x;
    if (other < 0.2 || other > 0.3) continue;
    certain = 0.0;
    longest = texelFetch(longest_tex, at, 0);
  }
  float shortest_px = spreadFactor(frame.shutter) * shortestIn(texelFetch(bounds_tex, cell, 0));
  bool is_drawn = frame.camera_rests == 0u && certain < 0.4 && shortest_px > kStaticRadius;
  imageStore(drawn_img, cell, vec4(is_drawn ? 1.0 : 0.0, 1, 0, 0));
  imageStore(untraced_img, cell, vec4(is_drawn ? 0.5 : certain < 0.4 ? 0.0 : certain));
  imageStore(first_ray_img, cell, longest);
}
