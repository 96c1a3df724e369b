// SPDX-License-Identifier: MIT
// Per tile, the longest displacement of the tiles around that can reach it (McGuire 2012, NeighborMax), and a second
// displacement that differs from the first.
// In:  `longest`:  longest displacement of each tile, px over the exposure
//      `velocities`:  xy, zw: two displacements that represent the tile, px over the exposure; absent: only `longest` is used
//      `curve`:    curve of the path of `longest`, px; absent: straight
//      `place`:    texel that has the displacement `longest`, px
// Out: `dominant`: longest accepted displacement, px over the exposure
//      `dominant_curve`, `dominant_place`: curve and texel of `dominant`; 0 if paths are straight
//      `second`:   accepted displacement, longer than 1/2 px, that differs most from `dominant`; `dominant` if none differs
// Method: test the tiles up to ceil(limit * width * r / tile) tiles away, where r is 1 for a one-sided and 1/2 for a centred
//      exposure. With `limit` = auto, the measured maximum replaces limit * width. The parameter `rule` decides:
//      - `all` accepts each tile.
//      - `sign` (Guertin et al. 2014) requires that the displacement brings the other tile here along each axis that separates
//      the two tiles. With a centred exposure, all components must point here, or all must point away.
//      - `swept_box` requires that the box of the other tile, swept along its displacement over the exposure, overlaps this
//      tile. It accepts a subset of the tiles that `sign` accepts. The test is exact for boxes at any distance.
//      A tile with a curved path is swept along it under every rule. At equal length the first in raster order wins.
// Fails: a tile is tested by its longest displacement alone. A slower pixel that reaches this tile is lost if the longest
//      displacement does not reach it.
#include "mixin/path.glsl"

// Open interval of the times t when another tile overlaps this tile along one axis: |offset * tile_px + d * t| < tile_px.
// `offset`: offset of the other tile, tiles; `d`: its displacement along the axis, px. An empty interval is (1, -1).
vec2 overlapTimes(int offset, float d, float tile_px) {
  if (d == 0.0) return offset == 0 ? vec2(-1e30, 1e30) : vec2(1.0, -1.0);
  float a = (-tile_px - float(offset) * tile_px) / d;
  float b = (tile_px - float(offset) * tile_px) / d;
  return vec2(min(a, b), max(a, b));
}

bool reaches(ivec2 offset, vec2 d) {
  vec2 in_x = overlapTimes(offset.x, d.x, float(params.tile));
  vec2 in_y = overlapTimes(offset.y, d.y, float(params.tile));
  float first = max(in_x.x, in_y.x);
  float last = min(in_x.y, in_y.y);
  return first < last && first < frame.shutter.y && last > frame.shutter.x;
}

// True if the rule `sign` accepts a tile at `offset` with the displacement d. With the anchor `end`, a surface that was here
// before the raster time moves along +offset. With `start`, a surface that will be here later moves along -offset. A centred
// exposure accepts both directions.
bool pointsHere(ivec2 offset, vec2 d) {
  ivec2 signs = ivec2(sign(vec2(offset)) * sign(d));
  int needed = abs(sign(offset.x)) + abs(sign(offset.y));
  int found = signs.x + signs.y;
  if (isCentred(frame.shutter)) return abs(found) == needed;
  return found == (frame.shutter.x < 0.0 ? needed : -needed);
}

// Length of the straight displacement that reaches as far as the tile's longest path, px.
float lengthAt(ivec2 tile, vec2 d) {
  return reachOf(d, curve_at(tile), frame.shutter);
}

bool isCurved(ivec2 tile) {
  return curve_at(tile) != vec4(0);
}

// True if the box of the other tile, swept along its curve, overlaps this tile within the exposure. The curve is tested in 4 to
// 64 steps of about half a tile.
bool comesHere(ivec2 tile, ivec2 offset, vec2 d) {
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

// Displacement that differs more from `dominant`: `second` or d. If d is static (up to 1/2 px) or not accepted, the result is
// `second`.
vec2 otherThan(vec2 dominant, vec2 second, vec2 d, ivec2 offset) {
  if (lengthOf(d) <= 0.5 || lengthOf(d - dominant) <= lengthOf(second - dominant)) return second;
  return accepts(offset, d) ? d : second;
}

void run(ivec2 pixel) {
  ivec2 size = textureSize(longest_tex, 0);
  int radius = tilesInReach(reachPx(), params.tile, frame.shutter, size);
  ivec2 first = max(pixel - radius, ivec2(0));
  ivec2 last = min(pixel + radius, size - 1);

  vec2 dominant = vec2(0);
  vec4 curve = vec4(0);
  vec2 place = vec2(0);
  float dominant_length = 0.0;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      vec2 d = vec2(longest_at(ivec2(x, y)));
      ivec2 tile = ivec2(x, y);
      float d_length = lengthAt(tile, d);
      if (d_length <= dominant_length) continue;
      if (!(isCurved(tile) ? comesHere(tile, tile - pixel, d) : accepts(tile - pixel, d))) continue;
      dominant = d;
      curve = curve_at(tile);
      place = vec2(place_at(tile));
      dominant_length = d_length;
    }
  }

  vec2 second = dominant;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      ivec2 offset = ivec2(x, y) - pixel;
      second = otherThan(dominant, second, vec2(longest_at(ivec2(x, y))), offset);
      vec4 pair = velocities_at(ivec2(x, y));
      second = otherThan(dominant, second, vec2(pair.x, pair.y), offset);
      second = otherThan(dominant, second, vec2(pair.z, pair.w), offset);
    }
  }
  imageStore(dominant_img, pixel, vec4(dominant, 0, 0));
  imageStore(dominant_curve_img, pixel, curve);
  imageStore(dominant_place_img, pixel, vec4(place, 0, 0));
  imageStore(second_img, pixel, vec4(second, 0, 0));
}
