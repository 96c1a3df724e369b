// SPDX-License-Identifier: MIT
// Samples of a tile.
// In:  tile_error (per tile: its own; a smoother one), rate (one texel, of sample_rate.glsl: the rate; the most that a
//      tile gets).
// Out: budget (samples).
#include "lib/audit.glsl"

void run(ivec2 tile) {
  vec4 rate = texelFetch(rate_tex, ivec2(0), 0);
  float everywhere = float(params.samples);
  float error = texelFetch(tile_error_tex, tile, 0).y;
  float samples = min(rate.x * pow(error, 2.0 / (2.0 * params.order + 1.0)), rate.y);
  // Pixels [first, end) of the tile in which anything that moves can be seen.
  ivec2 first = max(tile * params.tile, frame.reach.xy), end = min((tile + 1) * params.tile, frame.reach.zw);
  if (all(lessThan(first, end))) samples = max(samples, params.least * everywhere);
  if (isAudited(tile, params.audit)) samples = max(samples, everywhere);
  imageStore(budget_img, tile, vec4(samples));
}
