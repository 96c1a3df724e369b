// SPDX-License-Identifier: MIT
// Mask of the pixels that a filter computes if the filter runs at half resolution in tiles with heavy motion.
// In:  `shortest`: length of the shortest displacement of each tile, px over the exposure.
// Out: `mask`: 1 at pixels that the filter computes, otherwise 0.
// Method: in tiles whose shortest displacement is at least `heavy_motion`, mask the pixels with even x and even y. In other
//   tiles mask all pixels.
// Fails: a tile with one slow pixel counts as slow.
void run(ivec2 pixel) {
  bool is_heavy = shortest_at(pixel / params.tile).x >= params.heavy_motion;
  bool on_grid = (pixel & 1) == ivec2(0);
  imageStore(mask_img, pixel, vec4(on_grid || !is_heavy ? 1 : 0));
}
