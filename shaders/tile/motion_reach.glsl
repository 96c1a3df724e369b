// SPDX-License-Identifier: MIT
// Per cell, whether anything that moves is there at any time of the exposure, whether anything revealed is, and whether
// something comes there that moves unlike what filters try. Each cell says so of the cells that its surfaces come to.
// In:  bounds, behind_bounds (of the displacements of each cell, of what raster saw and of what was revealed);
//      dominant, second, after_*, revealed_* (per tile): the displacements that filters try there.
// Out: moved (1: something that moves is there at some time), behind (1: something revealed is), missed (1: something that
//      moves comes from another cell, and none of these displacements leads to it).
// Exact but for being too large: a cell reaches where its rectangle goes by any of its displacements, and as far around
// as filters look for what is at a pixel: max(3/4, reach / (2 * samples)) px.
#include "lib/bounds.glsl"
#include "mixin/limit.glsl"

bool isStill(vec4 bounds) {
  return reachFactor(frame.shutter) * longestIn(bounds) <= params.slowest + (kStillRadius - 0.5);
}

// Is a displacement so near to those of a box that a filter that tries it is led to them?
bool leadsTo(vec4 bounds, vec2 d) {
  float apart = lengthOf(d - clamp(d, lowOf(bounds), highOf(bounds)));
  return apart <= max(2.0, 0.14 * longestIn(bounds));
}

// Does none of those that are tried at a cell lead to what comes there?
bool isMissed(ivec2 cell, vec4 bounds) {
  ivec2 tile = cell * params.cell_side / params.tile;
  bool found = leadsTo(bounds, vec2(texelFetch(dominant_tex, tile, 0)));
#if HAS_second
  found = found || leadsTo(bounds, vec2(texelFetch(second_tex, tile, 0)));
#endif
#if HAS_after_dominant
  found = found || leadsTo(bounds, vec2(texelFetch(after_dominant_tex, tile, 0)));
#endif
#if HAS_after_second
  found = found || leadsTo(bounds, vec2(texelFetch(after_second_tex, tile, 0)));
#endif
#if HAS_revealed_dominant
  found = found || leadsTo(bounds, vec2(texelFetch(revealed_dominant_tex, tile, 0)));
#endif
#if HAS_revealed_after_dominant
  found = found || leadsTo(bounds, vec2(texelFetch(revealed_after_dominant_tex, tile, 0)));
#endif
  return !found;
}

// The cells, first and last, that a cell's surfaces come to.
ivec4 reachedBy(ivec2 cell, vec4 bounds) {
  float slack_px = max(0.75, reachPx() / float(2 * params.samples)) + 1.0;
  vec4 way = travelled(bounds, frame.shutter);
  vec2 side = vec2(params.cell_side), last_px = vec2(frame.size) - 1.0;
  vec2 first = vec2(cell) * side, last = min(first + side - 1.0, last_px);
  vec2 low = clamp(first + lowOf(way) - slack_px, vec2(0), last_px + 1.0);
  vec2 high = clamp(last + highOf(way) + slack_px, vec2(-1), last_px);
  return ivec4(floor(low / side), floor(high / side));
}

void mark(ivec2 cell, vec4 bounds, bool is_behind) {
  if (isEmpty(bounds) || (!is_behind && isStill(bounds))) return;
  ivec4 reached = reachedBy(cell, bounds);
  bool moves = !isStill(bounds);
  for (int y = reached.y; y <= reached.w; ++y) {
    for (int x = reached.x; x <= reached.z; ++x) {
      ivec2 at = ivec2(x, y);
      if (is_behind) imageStore(behind_img, at, vec4(1));
      if (moves) imageStore(moved_img, at, vec4(1));
      if (moves && at != cell && isMissed(at, bounds)) imageStore(missed_img, at, vec4(1));
    }
  }
}

void run(ivec2 cell) {
  mark(cell, texelFetch(bounds_tex, cell, 0), false);
  mark(cell, texelFetch(behind_bounds_tex, cell, 0), true);
}
