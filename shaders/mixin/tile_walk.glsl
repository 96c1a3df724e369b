// SPDX-License-Identifier: MIT
// Needs: longest_tex, params.tile; may have: PARAM_trajectory, curve_tex.
// Where a tile goes within the exposure, if all of it moves by its longest displacement: tiles along the line of its centre, one
// for each along the longer axis, from where it begins to where it ends; along its curve one at least every half a tile.
#ifndef STROBE_TILE_WALK_GLSL
#define STROBE_TILE_WALK_GLSL
#include "mixin/curve.glsl"

struct Walk {
  ivec2 from;
  vec2 d;           // tiles over the exposure; along a curve px
  vec4 curve;       // px
  float steps;      // tiles over the exposure, along the longer axis; along a curve, that it is followed in
  int first, last;  // steps from where it is now; along a curve from the exposure's start
};

vec4 curveOf(ivec2 tile) {
#if HAS_curve
  return texelFetch(curve_tex, tile, 0);
#else
  return vec4(0);
#endif
}

// How far a tile comes, px.
float lengthOfTile(ivec2 tile) {
  vec2 d = vec2(texelFetch(longest_tex, tile, 0));
#if HAS_curve
  return reachOf(d, curveOf(tile), frame.shutter);
#else
  return lengthOf(d);
#endif
}

// `tiles`: how many there are; what leaves them does not come back.
Walk walkOf(ivec2 tile, ivec2 tiles) {
  vec2 d_px = vec2(texelFetch(longest_tex, tile, 0));
#if HAS_curve
  vec4 curve = curveOf(tile);
  if (curve != vec4(0)) {
    int count = stepsAlong(d_px, curve, params.tile);
    return Walk(tile, d_px, curve, float(count), 0, count);
  }
#endif
  vec2 d = d_px / float(params.tile);
  float steps = max(abs(d.x), abs(d.y)), most = float(max(tiles.x, tiles.y));
  int before = int(ceil(min(-frame.shutter.x * steps, most))), after = int(ceil(min(frame.shutter.y * steps, most)));
  return Walk(tile, d, vec4(0), steps, -before, after);
}

// The tile at a step from `first` to `last`; the outermost are where the exposure ends.
ivec2 placeOf(Walk walk, int step) {
#if HAS_curve
  if (walk.curve != vec4(0)) {
    float t = evenTimeAt(float(step), int(walk.steps), frame.shutter);
    return walk.from + roundSymmetric(movedBy(walk.d, walk.curve, t, frame.shutter) / float(params.tile));
  }
#endif
  if (step == 0) return walk.from;
  float t = clamp(float(step) / walk.steps, frame.shutter.x, frame.shutter.y);
  return walk.from + roundSymmetric(walk.d * t);
}

#endif
