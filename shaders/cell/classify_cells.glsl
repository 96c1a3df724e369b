// SPDX-License-Identifier: MIT
// Three conservative flags per cell (a square of `cell_side` px): a moving surface is there at some time of the exposure; a
// revealed surface is there; a surface arrives with a displacement that is not a candidate of the composite. The pass
// `layered_composite` copies the pixels of cells without motion, and can leave samples in cells with such arrivals unresolved.
// In:  `bounds`, `background_bounds`: bounds of the displacements in each cell, of the raster layer and of the revealed layer,
//        px over the exposure (cell/velocity_bounds.glsl).
//      `dominant`, `second`: candidate displacements of each tile, px over the exposure.
//      `dominant_post`, `second_post`: candidates after the raster time (absent: `dominant`, `dominant_post`).
//      `revealed_dominant`, `revealed_dominant_post`: candidates of the revealed layer (absent: `dominant`, `dominant_post`).
// Out: `moved`: 1 if a surface that moves by more than `slowest` px is in the cell at some time.
//      `background`: 1 if a revealed surface is in the cell at some time.
//      `unlisted`: 1 if a moving surface arrives from another cell and no candidate displacement leads back to this surface.
// Method: each cell marks all cells that its rectangle overlaps when it moves by any displacement within its bounds. The
//   rectangle is widened by 1 px and by the search radius of the composite, max(3/4, R / (2 * samples)) px. R is the longest
//   displacement that filters handle, px, and `samples` the number of time samples of the composite.
// Fails: never misses a cell. A cell with different motions marks too many cells around it.
#include "lib/bounds.glsl"
#include "mixin/limit.glsl"

// True if all displacements within the bounds move a surface by at most `slowest` px from its place at the raster time.
bool isStatic(vec4 bounds) {
  return spreadFactor(frame.shutter) * longestIn(bounds) <= params.slowest + (kStaticRadius - 0.5);
}

// True if a composite that follows the displacement d back finds all surfaces with displacements within `bounds`. d may be
// outside the bounds by 2 px, or by 14 % of the longest displacement if that is more (an angle of 8 degrees). These two
// tolerances are not derived.
bool leadsTo(vec4 bounds, vec2 d) {
  float apart = lengthOf(d - clamp(d, lowOf(bounds), highOf(bounds)));
  return apart <= max(2.0, 0.14 * longestIn(bounds));
}

// True if no candidate displacement of the cell's tile leads back to arriving surfaces with displacements within `bounds`.
bool isUnlisted(ivec2 cell, vec4 bounds) {
  ivec2 tile = cell * params.cell_side / params.tile;
  return !leadsTo(bounds, vec2(dominant_at(tile))) && !leadsTo(bounds, vec2(second_at(tile))) &&
         !leadsTo(bounds, vec2(dominant_post_at(tile))) && !leadsTo(bounds, vec2(second_post_at(tile))) &&
         !leadsTo(bounds, vec2(revealed_dominant_at(tile))) && !leadsTo(bounds, vec2(revealed_dominant_post_at(tile)));
}

// Rectangle of the cells that the surfaces of a cell reach within the exposure: first cell (x, y), last cell (z, w).
ivec4 reachedBy(ivec2 cell, vec4 bounds) {
  float slack_px = max(0.75, reachPx() / float(2 * params.samples)) + 1.0;
  vec4 way = travelled(bounds, frame.shutter);
  vec2 side = vec2(params.cell_side), last_px = vec2(frame.size) - 1.0;
  vec2 first = vec2(cell) * side, last = min(first + side - 1.0, last_px);
  vec2 low = clamp(first + lowOf(way) - slack_px, vec2(0), last_px + 1.0);
  vec2 high = clamp(last + highOf(way) + slack_px, vec2(-1), last_px);
  return ivec4(floor(low / side), floor(high / side));
}

// Sets the flags of all cells that the surfaces of one layer in `cell` reach. `is_background`: true for the revealed layer.
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
