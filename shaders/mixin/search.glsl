// SPDX-License-Identifier: MIT
// Needs: params.limit; may have: PARAM_trajectory, curve_tex, dominant_curve_tex, reach_tex.
// How a search for what is at a pixel at some time goes on from a texel that is not: where, of a guess, what the texel there
// says instead. Motion that varies over a surface (perspective, turning) is met by asking once more from where the first guess
// led. A texel that passes `isAt` is at the pixel, however it was found.
#ifndef STROBE_SEARCH_GLSL
#define STROBE_SEARCH_GLSL
#include "mixin/path.glsl"

// How often what a texel says is followed to another, and where paths are curved.
const int kGuesses = 2, kCurvedGuesses = 4;

// Is there another guess after the i-th?
bool isAskedAgain(int i, Path path) { return i + 1 < (isCurved(path) ? kCurvedGuesses : kGuesses); }

// A path that changes by more from texel to texel is another thing's, px.
const float kMostSlope = 2.0;

// Of the layers that are searched: the path of what a texel shows, and whether it shows anything. Whoever searches has these.
Path pathOf(int layer, ivec2 texel, bool after);
bool holds(int layer, ivec2 texel);

ivec2 asked(ivec2 pixel, Path path, float t, vec2 window) { return pixel + roundSymmetric(tapOffset(path, t, window)); }

#if HAS_curve
// By how much a path changes from a texel to the next along an axis, px at time t; 0 where the texels beside it are of
// something else.
vec2 slopeOf(int layer, ivec2 now, ivec2 axis, vec2 offset, float t, vec2 window) {
  for (int side = 1; side >= -1; side -= 2) {
    ivec2 at = now + side * axis;
    if (!holds(layer, at)) continue;
    vec2 slope = float(side) * (tapOffset(pathOf(layer, at, t > 0.0), t, window) - offset);
    if (dot(slope, slope) <= kMostSlope * kMostSlope) return slope;
  }
  return vec2(0);
}
#endif

// The same of a texel `now` of a layer. Where paths are curved things turn: they vary over a surface by as much as it turns,
// which is known of what turns on an arc and which the texels beside it show of others, so that Newton's step is taken. It
// leads there at once where a surface is turned or stretched alike.
ivec2 askedOf(int layer, ivec2 pixel, ivec2 now, Path path, float t, vec2 window) {
#if HAS_curve
  if (!isCurved(path)) return asked(pixel, path, t, window);
  vec2 offset = tapOffset(path, t, window);
  vec2 off = vec2(now - pixel) - offset;
#if ON_ARCS
  if (isTurning(path.curve)) return ivec2(round(vec2(now) - complexQuotient(off, complexExp(t * path.curve.zw))));
#endif
  mat2 change = mat2(vec2(1, 0) - slopeOf(layer, now, ivec2(1, 0), offset, t, window),
                     vec2(0, 1) - slopeOf(layer, now, ivec2(0, 1), offset, t, window));
  if (abs(determinant(change)) >= 0.1) return ivec2(round(vec2(now) - inverse(change) * off));
#endif
  return asked(pixel, path, t, window);
}

#endif
