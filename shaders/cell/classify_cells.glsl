// SPDX-License-Identifier: MIT
// Two conservative flags per cell (a square of `cell_side` px): `moved`, if a moving surface is in the cell at some
// time of the exposure; `background`, if a revealed surface is in the cell at some time. A revealed surface is a
// surface behind the raster layer that a ray has found. The pass `layered_composite` copies the pixels of cells without
// motion.
// In:  `bounds`, `background_bounds`: bounds of the displacements in each cell, of the raster layer and of the revealed layer,
//        px over the exposure (cell/velocity_bounds.glsl).
// Out: `moved`: 1 if the cell contains a moving surface at some time. A surface of either layer is moving if it gets
//        more than half a pixel away from its position at the raster time.
//      `background`: 1 if the cell contains a revealed surface at some time.
// Method: each cell marks all cells that its rectangle overlaps when the rectangle moves by any displacement within the
//   bounds of the cell. The rectangle is widened by 1 px and by the search radius of the composite,
//   max(3/4, R / (2 * samples)) px. R is the longest displacement that filters handle, px, and `samples` the number of
//   time samples of the composite.
// Fails: never misses a cell. A cell with different motions marks too many cells around it.
#include "lib/bounds.glsl"
#include "mixin/limit.glsl"

// True if all displacements within the bounds keep a surface within its pixel.
bool isStatic(vec4 bounds) { return spreadFactor(frame.shutter) * longestIn(bounds) <= kStaticRadius; }

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
    }
  }
}

void run(ivec2 cell) {
  mark(cell, bounds_at(cell), false);
  mark(cell, background_bounds_at(cell), true);
}
