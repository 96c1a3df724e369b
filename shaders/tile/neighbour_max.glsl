// SPDX-License-Identifier: MIT
// Per tile, the longest displacement of the surrounding tiles that can reach this tile within the exposure (NeighborMax of
// McGuire et al. 2012), and a second displacement that differs from it.
// In:  `longest`: longest displacement of each tile, px over the exposure.
//      `velocities`: two displacements (xy, zw) that represent each tile besides `longest`, px over the exposure (absent:
//        none).
//      `curve`, `place`: curve of the path of `longest` (mixin/curve.glsl), and position of its texel, px (absent: paths are
//        straight).
// Out: `dominant`: longest accepted displacement, px over the exposure.
//      `dominant_curve`, `dominant_place`: curve of the path of `dominant`, and position of its texel, px; 0 if paths are
//        straight.
//      `second`: accepted displacement, longer than 1/2 px, that differs most from `dominant`; `dominant` if none differs.
// Method: test all tiles up to ceil(L * r / side) tiles away. L is `limit` times the image width or, with `limit` =
//   auto, the longest displacement of the image, px. r is 1 for a one-sided and 1/2 for a centred exposure. side is the
//   side of a tile, px. The parameter `rule` decides which tiles are accepted:
//   - `all`: every tile.
//   - `sign` (Guertin et al. 2014): tiles whose displacement has the right sign along x if the two tiles are in
//     different columns, and along y if they are in different rows. A surface with the right sign gets from that tile
//     to this one within the exposure, if it is fast enough. A centred exposure also accepts the opposite signs, for
//     both components together.
//   - `swept_box`: tiles whose box, swept along the displacement over the exposure, overlaps this tile. Accepts a subset of the
//     tiles that `sign` accepts, and is exact at any distance.
//   A tile with a curved path is swept along the curve under every rule. Of equally long displacements the first in raster
//   order wins.
// Fails: a tile is tested by its longest displacement alone. A slower pixel that reaches this tile is lost if the longest
//   displacement does not reach it.
#include "mixin/path.glsl"

// Open interval of the times t, in exposures, when another tile overlaps this tile along one axis: |offset * tile_px + d * t| <
// tile_px. `offset`: distance of the other tile, in tiles. `d`: its displacement along the axis, px over the exposure.
// `tile_px`: side of a tile. The interval (1, -1) is empty.
vec2 overlapTimes(int offset, float d, float tile_px) {
  if (d == 0.0) return offset == 0 ? vec2(-1e30, 1e30) : vec2(1.0, -1.0);
  float a = (-tile_px - float(offset) * tile_px) / d;
  float b = (tile_px - float(offset) * tile_px) / d;
  return vec2(min(a, b), max(a, b));
}

// True if the box of the tile at `offset`, moved by d, overlaps this tile at some time of the exposure (rule `swept_box`).
bool reaches(ivec2 offset, vec2 d) {
  vec2 in_x = overlapTimes(offset.x, d.x, float(params.tile));
  vec2 in_y = overlapTimes(offset.y, d.y, float(params.tile));
  float first = max(in_x.x, in_y.x);
  float last = min(in_x.y, in_y.y);
  return first < last && first < frame.shutter.y && last > frame.shutter.x;
}

// True if the rule `sign` accepts the tile at `offset` with the displacement d: d has the required sign along each axis where
// the offset is not 0. With the anchor `end`, the exposure is before the raster time. A surface that is in the other tile at
// the raster time was here during the exposure if it moves along +offset. With `start`, it will be here if it moves along
// -offset. A centred exposure accepts both directions.
bool pointsHere(ivec2 offset, vec2 d) {
  ivec2 signs = ivec2(sign(vec2(offset)) * sign(d));
  int needed = abs(sign(offset.x)) + abs(sign(offset.y));
  int found = signs.x + signs.y;
  if (isCentred(frame.shutter)) return abs(found) == needed;
  return found == (frame.shutter.x < 0.0 ? needed : -needed);
}

// Length of a straight displacement that moves a surface at least as far as the tile's longest path, px.
float lengthAt(ivec2 tile, vec2 d) {
  return reachOf(d, curve_at(tile), frame.shutter);
}

bool isCurved(ivec2 tile) {
  return curve_at(tile) != vec4(0);
}

// True if the box of another tile, swept along its curved path, overlaps this tile within the exposure. `tile`: the other tile;
// `offset`: its distance from this tile, in tiles; d: its displacement. The path is tested at 4 to 64 steps, four for each tile
// of its reach.
bool reachesOnCurve(ivec2 tile, ivec2 offset, vec2 d) {
  vec4 curve = curve_at(tile);
  vec2 at = vec2(offset * params.tile), side = vec2(params.tile);
  int steps = stepsAlong(d, curve, params.tile);
  for (int i = 0; i <= steps; ++i) {
    vec2 moved = movedBy(d, curve, evenTimeAt(float(i), steps, frame.shutter), frame.shutter);
    if (all(lessThan(abs(at + moved), side))) return true;
  }
  return false;
}

bool accepts(ivec2 offset, vec2 d) {
#if PARAM_rule == rule_swept_box
  return reaches(offset, d);
#elif PARAM_rule == rule_sign
  return pointsHere(offset, d);
#else
  return true;
#endif
}

// The one of the displacements `second` and d that differs more from `dominant`. d counts only if it is longer than 1/2 px and
// if the tile at `offset`, which has the displacement d, is accepted.
vec2 otherThan(vec2 dominant, vec2 second, vec2 d, ivec2 offset) {
  if (lengthOf(d) <= 0.5 || lengthOf(d - dominant) <= lengthOf(second - dominant)) return second;
  return accepts(offset, d) ? d : second;
}

void run(ivec2 tile) {
  ivec2 size = textureSize(longest_tex, 0);
  int radius = tilesInReach(reachPx(), params.tile, frame.shutter, size);
  ivec2 first = max(tile - radius, ivec2(0));
  ivec2 last = min(tile + radius, size - 1);

  vec2 dominant = vec2(0);
  vec4 curve = vec4(0);
  vec2 place = vec2(0);
  float dominant_length = 0.0;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      ivec2 other = ivec2(x, y);
      vec2 d = vec2(longest_at(other));
      float d_length = lengthAt(other, d);
      if (d_length <= dominant_length) continue;
      if (!(isCurved(other) ? reachesOnCurve(other, other - tile, d) : accepts(other - tile, d))) continue;
      dominant = d;
      curve = curve_at(other);
      place = vec2(place_at(other));
      dominant_length = d_length;
    }
  }

  vec2 second = dominant;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      ivec2 offset = ivec2(x, y) - tile;
      second = otherThan(dominant, second, vec2(longest_at(ivec2(x, y))), offset);
      vec4 pair = velocities_at(ivec2(x, y));
      second = otherThan(dominant, second, vec2(pair.x, pair.y), offset);
      second = otherThan(dominant, second, vec2(pair.z, pair.w), offset);
    }
  }
  imageStore(dominant_img, tile, vec4(dominant, 0, 0));
  imageStore(dominant_curve_img, tile, curve);
  imageStore(dominant_place_img, tile, vec4(place, 0, 0));
  imageStore(second_img, tile, vec4(second, 0, 0));
}
