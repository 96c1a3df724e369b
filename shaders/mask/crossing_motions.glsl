// SPDX-License-Identifier: MIT
// Per cell, which of the displacements found around it can uncover anything: the relative mask walks for these alone.
// In:  bounds (of the displacements of each cell), ids (least and greatest instance + 1 of each cell);
//      motions_0 .. motions_3: displacements found around each tile.
// Out: crossing_0 .. crossing_3: those that count, in their order (kNoMotion after the last).
// A displacement b is left out if no walk for it (mask/relative.glsl) can end otherwise than with "no": if every cell
// that a path -t*(d - b) from a pixel of this one may enter, d in the cell's bounds,
//   shows this cell's only instance, or holds nothing that moves by about b and nothing that moves relative to this
//   cell by half a pixel, for which a second walk would be made.
// Where a silhouette ends behind an occluder the walk goes on by `limit`, so paths are taken that much longer. What is
// outside of the picture is not known and uncovers nothing. The mask is the same bit for bit.
// Fails: a cell across the border of tiles tries the candidates of each, up to eight.
#include "lib/bounds.glsl"
#include "lib/motions.glsl"
#include "mixin/limit.glsl"

// Rounding of what is compared, px.
const float kSlack = 1e-2;

// Pixels, inclusive, relative to where a path begins: those of its steps, and with those behind an occluder.
struct Path {
  vec4 steps, farthest;
};

// The paths of displacements `from_b` = d - b up to time t.
Path pathOf(vec4 from_b, float t) {
  vec2 a = -t * lowOf(from_b), b = -t * highOf(from_b);
  vec2 low = min(a, b), high = max(a, b);
  // What goes on goes on in its direction: along an axis at most by that share.
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

// Is anything in a cell such that a walk from `own` for b does not go on past it?
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

// Those that count, in order; `asked` has those that were looked at.
struct Motions {
  vec2 d[kMaxMotions];
  int count;
  vec2 asked[kMaxMotions];
  int asked_count;
};

Motions with(Motions motions, Cell own, vec2 b) {
  if (!isMotion(b) || motions.asked_count == kMaxMotions) return motions;
  for (int i = 0; i < motions.asked_count; ++i) {
    if (motions.asked[i] == b) return motions;
  }
  motions.asked[motions.asked_count] = b;
  motions.asked_count += 1;
  if (!crosses(own, b)) return motions;
  motions.d[motions.count] = b;
  motions.count += 1;
  return motions;
}

Motions withTile(Motions motions, Cell own, ivec2 tile) {
  vec4 pairs[kMaxMotions / 2] = vec4[kMaxMotions / 2](texelFetch(motions_0_tex, tile, 0), texelFetch(motions_1_tex, tile, 0),
                                                      texelFetch(motions_2_tex, tile, 0), texelFetch(motions_3_tex, tile, 0));
  for (int i = 0; i < kMaxMotions; ++i)
    motions = with(motions, own, (i & 1) == 0 ? pairs[i / 2].xy : pairs[i / 2].zw);
  return motions;
}

void run(ivec2 cell) {
  Cell own = cellAt(cell);
  Motions motions;
  motions.count = motions.asked_count = 0;
  // One tile, unless the cell lies across the border of some.
  ivec2 from = own.first / params.tile, to = own.last / params.tile;
  for (int k = 0; k < 4; ++k) {  // in a loop: each copy of what a motion crosses takes long to compile
    bool is_right = (k & 1) != 0, is_below = (k & 2) != 0;
    if ((is_right && to.x == from.x) || (is_below && to.y == from.y)) continue;
    motions = withTile(motions, own, ivec2(is_right ? to.x : from.x, is_below ? to.y : from.y));
  }
  for (int i = motions.count; i < kMaxMotions; ++i) motions.d[i] = vec2(kNoMotion);

  imageStore(crossing_0_img, cell, vec4(motions.d[0], motions.d[1]));
  imageStore(crossing_1_img, cell, vec4(motions.d[2], motions.d[3]));
  imageStore(crossing_2_img, cell, vec4(motions.d[4], motions.d[5]));
  imageStore(crossing_3_img, cell, vec4(motions.d[6], motions.d[7]));
}
