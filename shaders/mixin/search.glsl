// SPDX-License-Identifier: MIT
// Needs: params.limit; may have: PARAM_trajectory, curve_tex, dominant_curve_tex, reach_tex.
// How a search for what is at a pixel at some time goes on from a texel that is not: where, of a guess, what the texel there
// says instead. Motion that varies over a surface (perspective, turning) is met by asking once more from where the first guess
// led. A texel that passes `isAt` is at the pixel, however it was found.
#ifndef STROBE_SEARCH_GLSL
#define STROBE_SEARCH_GLSL
#include "mixin/path.glsl"

// Of displacements whose texel nobody knows.
const ivec2 kNoTexel = ivec2(-1);

// How often what a texel says is followed to another, and where paths are curved. Loops over two are unrolled.
#if HAS_curve
const int kGuesses = 2, kCurvedGuesses = 4;
#else
const int kGuesses = 2, kCurvedGuesses = kGuesses;
#endif

// Is there another guess after the i-th?
bool isAskedAgain(int i, Path path) { return i + 1 < (isCurved(path) ? kCurvedGuesses : kGuesses); }

// A path that changes by more from texel to texel is another thing's, px.
const float kMostSlope = 2.0;

// Of the layers that are searched: the path of what a texel shows, and whether it shows anything. Whoever searches has these.
Path pathOf(int layer, ivec2 texel, bool after);
bool hasSurface(int layer, ivec2 texel);

ivec2 asked(ivec2 pixel, Path path, float t) { return pixel + roundSymmetric(tapOffset(path, t)); }

#if HAS_curve
// By how much a path changes from a texel to the next along an axis, px at time t; not known where the texels beside it are
// of something else.
struct Slope {
  vec2 px;
  bool is_known;
};

Slope slopeOf(int layer, ivec2 now, ivec2 axis, Path path, float t) {
  vec2 offset = tapOffset(path, t);
  for (int side = 1; side >= -1; side -= 2) {
    ivec2 at = now + side * axis;
    if (!hasSurface(layer, at)) continue;
    Path beside = pathOf(layer, at, t > 0.0);
    vec2 slope = tapOffset(beside, t) - offset, over_all = beside.d - path.d;
    if (max(dot(slope, slope), dot(over_all, over_all)) <= kMostSlope * kMostSlope) return Slope(float(side) * slope, true);
  }
  return Slope(vec2(0), false);
}

// By how much the place at time t changes with the texel. At corners, where one axis alone is known, as if what is there
// turned and grew alike in all directions: half-known it would lead far astray from afar.
mat2 changeOf(int layer, ivec2 now, Path path, float t) {
  Slope x = slopeOf(layer, now, ivec2(1, 0), path, t), y = slopeOf(layer, now, ivec2(0, 1), path, t);
  if (!x.is_known) x.px = vec2(y.px.y, -y.px.x);
  if (!y.is_known) y.px = vec2(-x.px.y, x.px.x);
  return mat2(vec2(1, 0) - x.px, vec2(0, 1) - y.px);
}
#endif

// Where a texel `now` of a layer leads. Where paths are curved things turn: they vary over a surface by as much as it turns,
// which is known of what turns on an arc and which the texels beside it show of others, so that Newton's step is taken. It
// leads there at once where a surface is turned or stretched alike.
ivec2 askedOf(int layer, ivec2 pixel, ivec2 now, Path path, float t) {
#if HAS_curve
  if (!isCurved(path)) return asked(pixel, path, t);
  vec2 offset = tapOffset(path, t);
  vec2 off = vec2(now - pixel) - offset;
#if ON_ARCS
  if (isTurning(path.curve)) return ivec2(round(vec2(now) - complexQuotient(off, complexExp(t * path.curve.zw))));
#endif
  mat2 change = changeOf(layer, now, path, t);
  if (abs(determinant(change)) >= 0.1) return ivec2(round(vec2(now) - inverse(change) * off));
#endif
  return asked(pixel, path, t);
}

#endif
