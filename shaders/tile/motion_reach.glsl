// SPDX-License-Identifier: MIT
// Per cell, whether anything that moves is there at any time of the exposure, and whether anything revealed is.
// In:  bounds, behind_bounds (of the displacements of each cell, of what raster saw and of what was revealed);
//      dominant, after_dominant, revealed_* (per tile): where nothing comes by these, nothing does.
// Out: moved (1: something that moves is there at some time), behind (1: something revealed is).
// Exact but for being too large: a cell reaches where its rectangle goes by any of its displacements, and as far around
// as filters look for what is at a pixel: max(3/4, limit / (2 * samples)) px.
#include "lib/bounds.glsl"
#include "mixin/limit.glsl"

struct Cell {
  vec2 first, last;  // pixels, inclusive
};

Cell cellAt(ivec2 cell) {
  ivec2 first = cell * params.cell_side;
  return Cell(vec2(first), vec2(min(first + params.cell_side, ivec2(frame.size)) - 1));
}

bool isStill(vec4 bounds) { return reachFactor(frame.shutter) * longestIn(bounds) <= kStillRadius; }

bool comesHere(Cell here, ivec2 cell, vec4 bounds, float slack_px) {
  Cell there = cellAt(cell);
  vec4 way = travelled(bounds, frame.shutter);
  return all(lessThanEqual(there.first + lowOf(way) - slack_px, here.last)) &&
         all(greaterThanEqual(there.last + highOf(way) + slack_px, here.first));
}

float fastestAround(Cell here) {
  ivec2 from = ivec2(here.first) / params.tile, to = ivec2(here.last) / params.tile;
  float fastest = 0.0;
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) {
      fastest = max(fastest, lengthOf(vec2(texelFetch(dominant_tex, ivec2(x, y), 0))));
#if HAS_after_dominant
      fastest = max(fastest, lengthOf(vec2(texelFetch(after_dominant_tex, ivec2(x, y), 0))));
#endif
#if HAS_revealed_dominant
      fastest = max(fastest, lengthOf(vec2(texelFetch(revealed_dominant_tex, ivec2(x, y), 0))));
#endif
#if HAS_revealed_after_dominant
      fastest = max(fastest, lengthOf(vec2(texelFetch(revealed_after_dominant_tex, ivec2(x, y), 0))));
#endif
    }
  }
  return fastest;
}

void run(ivec2 cell) {
  Cell here = cellAt(cell);
  bool moved = false, behind = false;
  if (reachFactor(frame.shutter) * fastestAround(here) > kStillRadius) {
    float limit_px = reachPx();
    float slack_px = max(0.75, limit_px / float(2 * params.samples)) + 1.0;
    ivec2 cells = textureSize(bounds_tex, 0);
    int around = tilesInReach(limit_px + slack_px / reachFactor(frame.shutter), params.cell_side, frame.shutter, cells);
    ivec2 from = max(cell - around, ivec2(0)), to = min(cell + around, cells - 1);
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) {
        vec4 bounds = texelFetch(bounds_tex, ivec2(x, y), 0);
        vec4 behind_bounds = texelFetch(behind_bounds_tex, ivec2(x, y), 0);
        bool comes_behind = !isEmpty(behind_bounds) && comesHere(here, ivec2(x, y), behind_bounds, slack_px);
        behind = behind || comes_behind;
        moved = moved || (comes_behind && !isStill(behind_bounds)) ||
                (!isStill(bounds) && comesHere(here, ivec2(x, y), bounds, slack_px));
      }
    }
  }
  imageStore(moved_img, cell, vec4(moved ? 1 : 0));
  imageStore(behind_img, cell, vec4(behind ? 1 : 0));
}
