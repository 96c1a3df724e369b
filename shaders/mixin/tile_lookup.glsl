// SPDX-License-Identifier: MIT
// Needs: params.tile, PARAM_tile_jitter.
// Lookup of the tile that gives a pixel its dominant displacement: the pixel's own tile, or the tile of a point up to a quarter
// of a tile away. Dominant displacements jump at the borders of tiles. The random offset of the point (the jitter) turns these
// visible borders into noise (Guertin et al. 2014, in the form of public implementations).
#ifndef STROBE_TILE_LOOKUP_GLSL
#define STROBE_TILE_LOOKUP_GLSL
#include "lib/blur.glsl"
#include "lib/noise.glsl"

const float kTwoPi = 6.28318530718;

// Offset of the looked-up point from the pixel, in tiles. The parameter `tile_jitter` chooses an offset of 1/4 tile at a random
// angle (`angle`), an offset of at most 1/4 tile in x or in y (`axis`), or 0 (`none`).
vec2 lookupShift(ivec2 pixel) {
#if PARAM_tile_jitter == tile_jitter_angle
  float angle = kTwoPi * gradientNoise(pixel + ivec2(2, 0));
  return 0.25 * vec2(cos(angle), sin(angle));
#elif PARAM_tile_jitter == tile_jitter_axis
  ivec2 tile = pixel / params.tile;
  float shift = 0.5 * gradientNoise(pixel) - 0.25;
  return (tile.x + tile.y) % 2 == 0 ? vec2(shift, 0) : vec2(0, shift);
#else
  return vec2(0);
#endif
}

// Tile that gives the pixel its dominant displacement. `tiles`: number of tiles per axis.
ivec2 lookupTile(ivec2 pixel, ivec2 tiles) {
#if PARAM_tile_jitter == tile_jitter_none
  return pixel / params.tile;
#else
  vec2 place = (vec2(pixel) + 0.5) / float(params.tile) + lookupShift(pixel);
  return clampToImage(ivec2(floor(place)), tiles);
#endif
}

#endif
