// SPDX-License-Identifier: MIT
// Per tile, the longest displacement around that can reach it (McGuire 2012, NeighborMax), and a second, different one.
// In:  `longest`:  longest displacement of each tile, px over the exposure
//      `velocities`:  xy, zw: two displacements that represent the tile, px over the exposure; absent: `longest` alone
//      `curve`:    curve of the path of `longest`, px; absent: straight
//      `place`:    texel that has `longest`, px
// Out: `dominant`: longest accepted displacement, px over the exposure
//      `dominant_curve`, `dominant_place`: curve and texel of `dominant`; 0 if paths are straight
//      `second`:   accepted displacement that differs most from `dominant`, longer than 1/2 px; `dominant` if none differs
// Method: test the tiles up to ceil(limit * width * r / tile) away, r = 1 one-sided, 1/2 centred; `limit` = auto: up to the
//      measured maximum. `all` accepts each. `sign` (Guertin et al. 2014): on each axis with an offset the displacement is not
//      0; one-sided, all components bring the tile here; centred, all point here or all point away. `swept_box` accepts a tile if
//      its box, swept along the displacement over the exposure, overlaps this tile: a subset of `sign`, exact for boxes at any
//      distance. A tile with a curved path is swept along it under every rule. At equal length the first in raster order wins.
// Fails: a tile is judged by its longest displacement: a slower pixel that reaches this tile is lost if the longest does not.
#include "mixin/path.glsl"

// Open interval of the times when a tile `offset` tiles away that moves by d (px along one axis) overlaps this tile
// along that axis: |offset * tile + d * t| < tile.
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

// Rule `sign`. With the anchor `end`, a surface at `offset` at the raster time that was here earlier moves along +offset.
// With `start`, a surface that will be here later moves along -offset. A centred exposure accepts both.
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

// True if the tile's box, swept along its curve, overlaps this tile within the exposure. Tested in 4 to 64 steps of about
// half a tile.
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

// The one of `second` and d that differs more from `dominant`. A static d, up to 1/2 px, is ignored.
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
