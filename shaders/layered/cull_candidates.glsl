// SPDX-License-Identifier: MIT
// Culls the candidate displacements of the background, per cell: drops candidates that cannot make the pass disocclusion_mask
// mark a pixel of the cell. Conservative; may keep a candidate without effect.
// In:  `bounds`: bounds of the displacements in each cell (least x and y, greatest x and y), px over the exposure
//      `ids`: least and greatest instance + 1 in each cell; 0 for the sky
//      `candidates_0` to `candidates_3`: candidate displacements of the background per tile, two per image, px over the
//        exposure
//      `max_displacement`: longest displacement in the image, px over the exposure; absent: twice the image's diagonal
// Out: `culled_0` to `culled_3`: candidates left in each cell, in the same order, two per image; kNoVelocity after the last
// Method: for each pixel and candidate b, disocclusion_mask walks from the pixel along the path -t*(d - b). d is the
//   pixel's displacement, and t the time of shutter open or shutter close, in exposures from the raster time. The pixel
//   is marked if the walk meets another instance that moves by about b. This pass tests the walks of all pixels of a
//   cell together: d is then any displacement in the cell's bounds. b is dropped if the walks can have no effect in any
//   cell that they may cross. Walks can have an effect in a cell only if both of these conditions hold:
//   - the cell and the cell where the walks begin show more than one instance together;
//   - the bounds of the cell contain a displacement within max(1 px, match * |d - b|) of b (parameter `match`), or a
//     displacement that moves half a pixel or more apart from d by the time t. The latter would start a second walk.
//   The paths are extended by the longest displacement, because a walk that ends on an occluder continues beyond the
//   occluder. Walks end at the border of the image. The mask is equal, bit for bit, to the mask without culling.
// Fails: a cell that overlaps several tiles keeps the candidates of each tile, up to eight in all. The disocclusion
//   mask may then have more pixels, and candidates beyond the eighth are lost.
#include "lib/bounds.glsl"
#include "lib/velocity_list.glsl"
#include "mixin/limit.glsl"

// Margin of comparisons for rounding errors, px. With the margin, more candidates are kept.
const float kSlack = 1e-2;

// Two boxes around a set of paths, as pixel offsets from the starts of the paths: least x and y, greatest x and y,
// inclusive. The box `steps` contains the paths themselves. The box `farthest` also contains their extensions: a walk
// that ends on an occluder continues beyond the end of its path, by at most the longest displacement.
struct Path {
  vec4 steps, farthest;
};

// Boxes around the paths -t*(d - b) for all displacements d of a cell. `from_b`: box of the differences d - b, px over the
// exposure. `t`: time at the end of the paths, in exposures from the raster time.
Path pathOf(vec4 from_b, float t) {
  vec2 a = -t * lowOf(from_b), b = -t * highOf(from_b);
  vec2 low = min(a, b), high = max(a, b);
  // Each extension continues in the direction of its path. `share`: upper bounds of |x| and |y| over the unit vectors
  // of these directions. An extension by L px therefore changes x and y by at most L * share.
  vec2 share = min(max(abs(low), abs(high)) / max(shortestIn(vec4(low, high)), 0.5), 1.0);
  vec2 slack = share * float(params.margin + 2) + 1.0;
  vec2 extension = slack + share * ceil(reachPx());
  vec2 back = vec2(lessThan(low, vec2(0))), forth = vec2(greaterThan(high, vec2(0)));
  low = min(low, 0.0);
  high = max(high, 0.0);
  return Path(vec4(low - slack, high + slack), vec4(low - back * extension - 1.0, high + forth * extension + 1.0));
}

struct Cell {
  ivec2 first, last;  // first and last pixel of the cell, inclusive
  vec4 bounds;
  uvec2 ids;
};

Cell cellAt(ivec2 cell) {
  ivec2 first = cell * params.cell_side;
  return Cell(first, min(first + params.cell_side, ivec2(frame.size)) - 1, texelFetch(bounds_tex, cell, 0),
              uvec2(texelFetch(ids_tex, cell, 0)));
}

// True if the cells `cell` and `own` show one common instance and no other.
bool isOneInstance(Cell own, ivec2 cell) {
  uvec2 ids = uvec2(texelFetch(ids_tex, cell, 0));
  return own.ids.x == own.ids.y && ids.x == own.ids.x && ids.y == own.ids.x;
}

// True if a walk for the candidate b from a pixel of the cell `own` may have an effect in the cell `cell`: end there, or start
// a second walk. `from_b` and `t` as in pathOf.
bool hasEffectIn(Cell own, ivec2 cell, vec4 from_b, vec2 b, float t) {
  vec4 there = texelFetch(bounds_tex, cell, 0);
  float matching_px = max(1.0, params.match * longestIn(from_b));
  bool matches = shortestIn(relativeTo(there, b)) <= matching_px + kSlack;
  bool moves = abs(t) * farthestApart(there, own.bounds) >= 0.5 - kSlack;
  return (matches || moves) && !isOneInstance(own, cell);
}

// True if a walk for the candidate b from a pixel of the cell `own`, until time t, may have an effect in any cell.
bool hasEffectUntil(Cell own, vec2 b, float t) {
  vec4 from_b = relativeTo(own.bounds, b);
  if (abs(t) * longestIn(from_b) < 0.5 - kSlack) return false;
  Path path = pathOf(from_b, t);
  ivec2 size = ivec2(frame.size);
  ivec2 from = clampToImage(own.first + ivec2(floor(lowOf(path.farthest))), size) / params.cell_side;
  ivec2 to = clampToImage(own.last + ivec2(ceil(highOf(path.farthest))), size) / params.cell_side;
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) {
      if (hasEffectIn(own, ivec2(x, y), from_b, b, t)) return true;
    }
  }
  return false;
}

bool hasEffect(Cell own, vec2 b) {
  for (int side = 0; side < 2; ++side) {
    float t = side == 0 ? min(frame.shutter.x, 0.0) : max(frame.shutter.y, 0.0);
    if (t != 0.0 && hasEffectUntil(own, b, t)) return true;
  }
  return false;
}

// Candidates that are kept (`d`), in order, and all candidates tested so far (`tried`). A candidate that several tiles share is
// tested once.
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
  if (!hasEffect(own, b)) return velocities;
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
  // First and last tile that overlap the cell. The cell takes the candidates of one, two or four tiles.
  ivec2 from = own.first / params.tile, to = own.last / params.tile;
  for (int k = 0; k < 4; ++k) {  // one loop for all tiles, because each inlined copy of hasEffect() takes long to compile
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
