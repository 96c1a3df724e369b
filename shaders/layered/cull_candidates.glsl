// SPDX-License-Identifier: MIT
// Per cell, the candidate background displacements that can make layered/disocclusion_mask.glsl mark one of its pixels
// (conservative).
// In:  bounds: range of the displacements of each cell, px over the exposure.
//      ids: least and greatest instance + 1 of each cell.
//      candidates_0 .. candidates_3: candidate displacements of each tile, two per image, px over the exposure.
//      max_displacement: longest displacement in the image, px over the exposure, one texel (optional).
// Out: culled_0 .. culled_3: the candidates kept, in their order, two per image; kNoVelocity after the last.
// Method: a candidate b is dropped if no walk for b from a pixel of the cell can mark the pixel. For every cell that a path
//   -t*(d - b) may enter, with d in this cell's bounds, one of these must hold:
//   - the other cell shows only the one instance of this cell;
//   - its bounds hold no displacement near b, within max(1 px, match * |d - b|), and no displacement that parts from this
//   cell's by half a pixel until t, which would start a second walk.
//   Paths are extended by the longest displacement, because a walk continues behind an occluder. Pixels outside the image do
//   not disocclude anything. The mask is the same, bit for bit, as with all candidates.
// Fails: a cell across tile borders keeps candidates of each tile, up to eight in all: it may mark more pixels, and loses
//   candidates beyond the eighth.
#include "lib/bounds.glsl"
#include "lib/velocity_list.glsl"
#include "mixin/limit.glsl"

// Slack for rounding in comparisons, px.
const float kSlack = 1e-2;

// Boxes around the pixels of all paths, relative to the first pixel: low x and y, high x and y, inclusive. `steps`: of the
// paths themselves; `farthest`: with their extension behind an occluder.
struct Path {
  vec4 steps, farthest;
};

// Paths -t*(d - b), for all `from_b` = d - b in a box.
Path pathOf(vec4 from_b, float t) {
  vec2 a = -t * lowOf(from_b), b = -t * highOf(from_b);
  vec2 low = min(a, b), high = max(a, b);
  // An extension follows the direction of its path: `share` is an upper bound of the unit direction along each axis.
  vec2 share = min(max(abs(low), abs(high)) / max(shortestIn(vec4(low, high)), 0.5), 1.0);
  vec2 on = share * float(params.margin + 2) + 1.0;
  vec2 far_on = on + share * ceil(reachPx());
  vec2 back = vec2(lessThan(low, vec2(0))), forth = vec2(greaterThan(high, vec2(0)));
  low = min(low, 0.0);
  high = max(high, 0.0);
  return Path(vec4(low - on, high + on), vec4(low - back * far_on - 1.0, high + forth * far_on + 1.0));
}

struct Cell {
  ivec2 first, last;  // pixels, inclusive
  vec4 bounds;
  uvec2 ids;
};

Cell cellAt(ivec2 cell) {
  ivec2 first = cell * params.cell_side;
  return Cell(first, min(first + params.cell_side, ivec2(frame.size)) - 1, texelFetch(bounds_tex, cell, 0),
              uvec2(texelFetch(ids_tex, cell, 0)));
}

bool isOneInstance(Cell own, ivec2 cell) {
  uvec2 ids = uvec2(texelFetch(ids_tex, cell, 0));
  return own.ids.x == own.ids.y && ids.x == own.ids.x && ids.y == own.ids.x;
}

// True if the cell may end a walk for b from a pixel of `own`.
bool concerns(Cell own, ivec2 cell, vec4 from_b, vec2 b, float t) {
  vec4 there = texelFetch(bounds_tex, cell, 0);
  float matching_px = max(1.0, params.match * longestIn(from_b));
  bool matches = shortestIn(relativeTo(there, b)) <= matching_px + kSlack;
  bool moves = abs(t) * farthestApart(there, own.bounds) >= 0.5 - kSlack;
  return (matches || moves) && !isOneInstance(own, cell);
}

bool crossesWithin(Cell own, vec2 b, float t) {
  vec4 from_b = relativeTo(own.bounds, b);
  if (abs(t) * longestIn(from_b) < 0.5 - kSlack) return false;
  Path path = pathOf(from_b, t);
  ivec2 size = ivec2(frame.size);
  ivec2 from = clampToImage(own.first + ivec2(floor(lowOf(path.farthest))), size) / params.cell_side;
  ivec2 to = clampToImage(own.last + ivec2(ceil(highOf(path.farthest))), size) / params.cell_side;
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) {
      if (concerns(own, ivec2(x, y), from_b, b, t)) return true;
    }
  }
  return false;
}

bool crosses(Cell own, vec2 b) {
  for (int side = 0; side < 2; ++side) {
    float t = side == 0 ? min(frame.shutter.x, 0.0) : max(frame.shutter.y, 0.0);
    if (t != 0.0 && crossesWithin(own, b, t)) return true;
  }
  return false;
}

// Candidates kept, in order, and all candidates tested (`tried`).
struct VelocityList {
  vec2 d[kMaxVelocities];
  int count;
  vec2 tried[kMaxVelocities];
  int tried_count;
};

VelocityList with(VelocityList velocities, Cell own, vec2 b) {
  if (!isVelocity(b) || velocities.tried_count == kMaxVelocities) return velocities;
  for (int i = 0; i < velocities.tried_count; ++i) {
    if (velocities.tried[i] == b) return velocities;
  }
  velocities.tried[velocities.tried_count] = b;
  velocities.tried_count += 1;
  if (!crosses(own, b)) return velocities;
  velocities.d[velocities.count] = b;
  velocities.count += 1;
  return velocities;
}

VelocityList withTile(VelocityList velocities, Cell own, ivec2 tile) {
  vec4 pairs[kMaxVelocities / 2] =
      vec4[kMaxVelocities / 2](texelFetch(candidates_0_tex, tile, 0), texelFetch(candidates_1_tex, tile, 0),
                               texelFetch(candidates_2_tex, tile, 0), texelFetch(candidates_3_tex, tile, 0));
  for (int i = 0; i < kMaxVelocities; ++i)
    velocities = with(velocities, own, (i & 1) == 0 ? pairs[i / 2].xy : pairs[i / 2].zw);
  return velocities;
}

void run(ivec2 cell) {
  Cell own = cellAt(cell);
  VelocityList velocities;
  velocities.count = velocities.tried_count = 0;
  // Tiles that overlap the cell: one, or up to four.
  ivec2 from = own.first / params.tile, to = own.last / params.tile;
  for (int k = 0; k < 4; ++k) {  // a loop, because each inlined copy of crosses() takes long to compile
    bool is_right = (k & 1) != 0, is_below = (k & 2) != 0;
    if ((is_right && to.x == from.x) || (is_below && to.y == from.y)) continue;
    velocities = withTile(velocities, own, ivec2(is_right ? to.x : from.x, is_below ? to.y : from.y));
  }
  for (int i = velocities.count; i < kMaxVelocities; ++i) velocities.d[i] = vec2(kNoVelocity);

  imageStore(culled_0_img, cell, vec4(velocities.d[0], velocities.d[1]));
  imageStore(culled_1_img, cell, vec4(velocities.d[2], velocities.d[3]));
  imageStore(culled_2_img, cell, vec4(velocities.d[4], velocities.d[5]));
  imageStore(culled_3_img, cell, vec4(velocities.d[6], velocities.d[7]));
}
