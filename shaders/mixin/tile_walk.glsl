// SPDX-License-Identifier: MIT
// Needs: longest_tex, params.tile.
// Walk over the tiles that a tile passes over within the exposure, if all its pixels move by its longest displacement. The walk
// follows the path of the tile's centre from shutter open to shutter close, with one step per tile along the longer axis of the
// displacement.
#ifndef STROBE_TILE_WALK_GLSL
#define STROBE_TILE_WALK_GLSL
#include "lib/blur.glsl"

// Walk that starts at one tile.
struct Walk {
  ivec2 from;       // the tile
  vec2 d;           // longest displacement of the tile, tiles over the exposure
  float steps;      // component of d along the longer axis, as a magnitude
  int first, last;  // numbers of the earliest step (<= 0) and the latest step (>= 0); step 0 is the tile itself
};

// Walk from `tile` along its longest displacement. `tiles`: number of tiles per axis. This number also bounds the number of
// steps, because a straight path that has left the image does not return.
Walk walkOf(ivec2 tile, ivec2 tiles) {
  vec2 d = vec2(texelFetch(longest_tex, tile, 0)) / float(params.tile);
  float steps = max(abs(d.x), abs(d.y)), most = float(max(tiles.x, tiles.y));
  int before = int(ceil(min(-frame.shutter.x * steps, most))), after = int(ceil(min(frame.shutter.y * steps, most)));
  return Walk(tile, d, steps, -before, after);
}

// Tile at a step of the walk. `step`: number of the step, from walk.first (at shutter open) to walk.last (at shutter close).
// The tile may be outside of the image.
ivec2 placeOf(Walk walk, int step) {
  if (step == 0) return walk.from;
  float t = clamp(float(step) / walk.steps, frame.shutter.x, frame.shutter.y);
  return walk.from + roundSymmetric(walk.d * t);
}

#endif
