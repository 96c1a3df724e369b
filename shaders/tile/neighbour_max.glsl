// SPDX-License-Identifier: MIT
// Per tile, the longest displacement of the tiles around it that can matter (McGuire 2012, NeighborMax), and a second
// one that differs from it.
// In:  longest (px over the exposure, per tile); motions (xy, zw: two displacements that stand for all in a tile;
//      absent: longest is all there is).
//      curve (of the path of longest, px; absent: it is a line); place (the texel that has it, px).
// Out: dominant, the longest accepted, with dominant_curve and dominant_place; second, the one accepted that differs most
//      from it and is not at rest (dominant again if there is none): what else moves here. Both px over the exposure.
// Tiles up to ceil(limit * width * reach / tile) away are asked, reach = 1 one-sided, 1/2 centred. Rule `all` accepts
// each of them. Rule `sign` is that of Guertin et al. 2014: a displacement must have a component along each axis on
// which its tile lies off this one, both or neither pointing here; for one-sided exposures all of them must bring it
// here. Rule `reach` accepts a displacement only if its tile's box, swept along it over the exposure window,
// overlaps this tile: never more than `sign` accepts, and exact for boxes at any distance. Ties go to the first in
// raster order.
// Layers of an end of the exposure have things where they are then: curves are followed from there, straight displacements
// are asked as if it were the capture.
// Fails: dominant judges a tile by its longest displacement; a slower pixel in it that comes this way while the longest
// does not is lost.
#include "mixin/path.glsl"

// Open interval of times at which a tile `offset` tiles away that moves by d (px along one axis) overlaps this tile
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

// For the anchor `close` what is now at `offset` and was here before moves along +offset, for `open` what will be here
// along -offset; with the capture in the middle either will do.
bool pointsHere(ivec2 offset, vec2 d) {
  ivec2 signs = ivec2(sign(vec2(offset)) * sign(d));
  int needed = abs(sign(offset.x)) + abs(sign(offset.y));
  int found = signs.x + signs.y;
  if (isCentred(frame.shutter)) return abs(found) == needed;
  return found == (frame.shutter.x < 0.0 ? needed : -needed);
}

// How far the longest of a tile comes, as a straight displacement.
float lengthAt(ivec2 tile, vec2 d) {
#if HAS_curve
  return reachOf(d, texelFetch(curve_tex, tile, 0), frame.shutter);
#else
  return lengthOf(d);
#endif
}

bool isCurved(ivec2 tile) {
#if HAS_curve
  return texelFetch(curve_tex, tile, 0) != vec4(0);
#else
  return false;
#endif
}

// Does the tile's box, moved along its curve, overlap this tile within the exposure? Looked at in steps of half a tile, or
// of 1/64 of the exposure, whatever the rule.
bool comesHere(ivec2 tile, ivec2 offset, vec2 d) {
#if HAS_curve
  vec4 curve = texelFetch(curve_tex, tile, 0);
  vec2 at = vec2(offset * params.tile), side = vec2(params.tile);
  int steps = stepsAlong(d, curve, params.tile);
  for (int i = 0; i <= steps; ++i) {
    vec2 moved = movedBy(d, curve, evenTimeAt(float(i), steps, frame.shutter), frame.shutter);
    if (all(lessThan(abs(at + moved), side))) return true;
  }
#endif
  return false;
}

bool accepts(ivec2 offset, vec2 d) {
#if PARAM_rule == rule_reach
  return reaches(offset, d);
#elif PARAM_rule == rule_sign
  return pointsHere(offset, d);
#else
  return true;
#endif
}

// The better of `second` and d as the displacement that differs most from `dominant`.
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
      vec2 d = vec2(texelFetch(longest_tex, ivec2(x, y), 0));
      ivec2 tile = ivec2(x, y);
      float d_length = lengthAt(tile, d);
      if (d_length <= dominant_length) continue;
      if (!(isCurved(tile) ? comesHere(tile, tile - pixel, d) : accepts(tile - pixel, d))) continue;
      dominant = d;
#if HAS_curve
      curve = texelFetch(curve_tex, tile, 0);
#endif
#if HAS_place
      place = vec2(texelFetch(place_tex, tile, 0));
#endif
      dominant_length = d_length;
    }
  }

  vec2 second = dominant;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      ivec2 offset = ivec2(x, y) - pixel;
      second = otherThan(dominant, second, vec2(texelFetch(longest_tex, ivec2(x, y), 0)), offset);
#if HAS_motions
      vec4 pair = texelFetch(motions_tex, ivec2(x, y), 0);
      second = otherThan(dominant, second, vec2(pair.x, pair.y), offset);
      second = otherThan(dominant, second, vec2(pair.z, pair.w), offset);
#endif
    }
  }
  imageStore(dominant_img, pixel, vec4(dominant, 0, 0));
  imageStore(dominant_curve_img, pixel, curve);
  imageStore(dominant_place_img, pixel, vec4(place, 0, 0));
  imageStore(second_img, pixel, vec4(second, 0, 0));
}
