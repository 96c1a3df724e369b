// SPDX-License-Identifier: MIT
// Of the tiles that had all samples: the error that their halves state, against what the first samples foresaw, an error
// that falls as 1/n^order. The first pixel of a tile checks it.
// In:  error (rgb: half the difference of the halves' means; a: number of samples), tile_error (per tile, of the first
//      samples: y as samples are shared out by).
// Out: error, as it is.
#include "lib/audit.glsl"

void check(ivec2 tile) {
  ivec2 first = tile * params.tile, end = min(first + params.tile, textureSize(error_tex, 0));
  float sum = 0.0, pixels = 0.0;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      vec3 error = vec3(texelFetch(error_tex, ivec2(x, y), 0));
      sum += dot(error, error);
      pixels += 1.0;
    }
  }
  float share = float(params.pilot) / texelFetch(error_tex, first, 0).a;
  float foreseen = texelFetch(tile_error_tex, tile, 0).y * pow(share, params.order);
  count_audited(1u);
  if (sqrt(sum / (3.0 * pixels)) > 2.0 * foreseen + 1e-6) count_off(1u);
}

void run(ivec2 pixel) {
  ivec2 tile = pixel / params.tile;
  if (pixel == tile * params.tile && isAudited(tile, params.audit)) check(tile);
  imageStore(error_img, pixel, texelFetch(error_tex, pixel, 0));
}
