// SPDX-License-Identifier: MIT
// From the first samples' two halves to the standard error of their mean: half the difference of the halves' means.
// In:  spread (per tile: sum of squared differences over pixels and channels; pixels).
// Out: tile_error (standard error of the first samples' mean, linear radiance: x of the tile, y the larger of that and of
//      the root mean square over it and the eight around it).
float squareOf(ivec2 tile) {
  vec4 spread = texelFetch(spread_tex, tile, 0);
  return spread.y > 0.0 ? 0.25 * spread.x / (3.0 * spread.y) : 0.0;
}

void run(ivec2 tile) {
  ivec2 size = textureSize(spread_tex, 0);
  float sum = 0.0, count = 0.0;
  for (int y = max(tile.y - 1, 0); y <= min(tile.y + 1, size.y - 1); ++y) {
    for (int x = max(tile.x - 1, 0); x <= min(tile.x + 1, size.x - 1); ++x) {
      sum += squareOf(ivec2(x, y));
      count += 1.0;
    }
  }
  float own = squareOf(tile);
  imageStore(tile_error_img, tile, vec4(sqrt(own), sqrt(max(own, sum / count)), 0, 0));
}
