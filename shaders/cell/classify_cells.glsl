// SPDX-License-Identifier: MIT
// Per cell, conservative flags: a moving surface is present at some time of the exposure, a revealed surface is, and a surface
// arrives whose displacement no filter candidate matches.
// In:  `bounds`, `background_bounds`: displacements of each cell, of the raster layer and of the revealed layer, px over the
//                exposure
//      `dominant`, `second`: candidate displacements of the tile, px over the exposure
//      `dominant_post`, `second_post`: candidates after the raster time; absent: none
//      `revealed_dominant`, `revealed_dominant_post`: candidates of the revealed layer; absent: none
// Out: `moved`:  1 if a surface that moves by more than `slowest` px is present at some time
//      `background`: 1 if a revealed surface is present at some time
//      `unlisted`: 1 if a moving surface arrives from another cell and no candidate leads to it
// Method: each cell marks all cells that its rectangle overlaps after moving by any of its displacements, widened by the search
//      radius of the filters, max(3/4, r / (2 * samples)) px with r the longest displacement that filters handle, and by 1 px.
// Fails: never; conservative. A cell with different motions marks too many cells around it.
#include "lib/bounds.glsl"
#include "mixin/limit.glsl"

bool isStatic(vec4 bounds) {
  return spreadFactor(frame.shutter) * longestIn(bounds) <= params.slowest + (kStaticRadius - 0.5);
}

// True if a filter that tries displacement d finds the surfaces of the box. The distance allowed, the larger of 2 px and
// 14 % of the longest displacement (8 degrees), is not derived.
bool leadsTo(vec4 bounds, vec2 d) {
  float apart = lengthOf(d - clamp(d, lowOf(bounds), highOf(bounds)));
  return apart <= max(2.0, 0.14 * longestIn(bounds));
}

// True if no candidate of the cell's tile leads to the surfaces that arrive.
bool isUnlisted(ivec2 cell, vec4 bounds) {
  ivec2 tile = cell * params.cell_side / params.tile;
  return !leadsTo(bounds, vec2(dominant_at(tile))) && !leadsTo(bounds, vec2(second_at(tile))) &&
         !leadsTo(bounds, vec2(dominant_post_at(tile))) && !leadsTo(bounds, vec2(second_post_at(tile))) &&
         !leadsTo(bounds, vec2(revealed_dominant_at(tile))) && !leadsTo(bounds, vec2(revealed_dominant_post_at(tile)));
}

// First and last cell that a cell's surfaces reach.
ivec4 reachedBy(ivec2 cell, vec4 bounds) {
  float slack_px = max(0.75, reachPx() / float(2 * params.samples)) + 1.0;
  vec4 way = travelled(bounds, frame.shutter);
  vec2 side = vec2(params.cell_side), last_px = vec2(frame.size) - 1.0;
  vec2 first = vec2(cell) * side, last = min(first + side - 1.0, last_px);
  vec2 low = clamp(first + lowOf(way) - slack_px, vec2(0), last_px + 1.0);
  vec2 high = clamp(last + highOf(way) + slack_px, vec2(-1), last_px);
  return ivec4(floor(low / side), floor(high / side));
}

void mark(ivec2 cell, vec4 bounds, bool is_background) {
  if (isEmpty(bounds) || (!is_background && isStatic(bounds))) return;
  ivec4 reached = reachedBy(cell, bounds);
  bool moves = !isStatic(bounds);
  for (int y = reached.y; y <= reached.w; ++y) {
    for (int x = reached.x; x <= reached.z; ++x) {
      ivec2 at = ivec2(x, y);
      if (is_background) imageStore(background_img, at, vec4(1));
      if (moves) imageStore(moved_img, at, vec4(1));
      if (moves && at != cell && isUnlisted(at, bounds)) imageStore(unlisted_img, at, vec4(1));
    }
  }
}

void run(ivec2 cell) {
  mark(cell, bounds_at(cell), false);
  mark(cell, background_bounds_at(cell), true);
}
