// SPDX-License-Identifier: MIT
// Needs: longest_tex, params.tile.
// Walk over the tiles that one tile passes over within the exposure if all its pixels move by its longest displacement. The
// walk follows the line of the tile's centre from shutter open to shutter close, with one tile for each step along the longer
// axis.
#ifndef STROBE_TILE_WALK_GLSL
#define STROBE_TILE_WALK_GLSL
#include "lib/blur.glsl"

struct Walk {
  ivec2 from;
  vec2 d;           // tiles over the exposure
  float steps;      // tiles over the exposure, along the longer axis
  int first, last;  // numbers of the outermost steps; step 0 is the tile itself
};

// Walk from `tile` to the tiles along its longest displacement. `tiles`: number of tiles per axis; it bounds the number of
// steps, because a straight path that leaves the image does not return.
Walk walkOf(ivec2 tile, ivec2 tiles) {
  vec2 d = vec2(texelFetch(longest_tex, tile, 0)) / float(params.tile);
  float steps = max(abs(d.x), abs(d.y)), most = float(max(tiles.x, tiles.y));
  int before = int(ceil(min(-frame.shutter.x * steps, most))), after = int(ceil(min(frame.shutter.y * steps, most)));
  return Walk(tile, d, steps, -before, after);
}

// Tile at a step of the walk, from `first` to `last`. The outermost steps are at the ends of the exposure.
ivec2 placeOf(Walk walk, int step) {
  if (step == 0) return walk.from;
  float t = clamp(float(step) / walk.steps, frame.shutter.x, frame.shutter.y);
  return walk.from + roundSymmetric(walk.d * t);
}

#endif
