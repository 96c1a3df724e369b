// SPDX-License-Identifier: MIT
// Needs: nothing; may have: PARAM_trajectory.
// Curved screen paths of surface points: parabolas or arcs through poses inside the exposure. The vec4 `curve`
// describes how a path deviates from the straight line between its ends. At the fraction u of the exposure (0 at
// shutter open, 1 at shutter close), with x = u - 1/2, the deviation in px is one of these formulas:
//   for a parabola:  4 u (1 - u) b
//   for an arc:      b (exp(w x) - cosh(w/2) - 2 x sinh(w/2)) / (1 - cosh(w/2)), in complex numbers
// b = curve.xy is the deviation in the middle of the exposure, px. w = curve.zw describes an arc: over the exposure,
// the path scales by exp(w.x) and rotates by w.y radians about a centre. The centre itself may move along a line: a
// point on a rolling wheel has such a path. An arc with w = 0 is a parabola. With curve = 0 the path is the straight
// line, bit for bit.
#ifndef STROBE_CURVE_GLSL
#define STROBE_CURVE_GLSL
#include "lib/blur.glsl"

#if defined(PARAM_trajectory) && PARAM_trajectory == trajectory_arc
#define ON_ARCS 1
#else
#define ON_ARCS 0
#endif

#if ON_ARCS
// Product, quotient and exponential of complex numbers (x real, y imaginary). The divisor b must not be 0.
vec2 complexProduct(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }
vec2 complexQuotient(vec2 a, vec2 b) { return complexProduct(a, vec2(b.x, -b.y)) / dot(b, b); }
vec2 complexExp(vec2 z) { return exp(z.x) * vec2(cos(z.y), sin(z.y)); }

// Magnitude of w below which three terms of a series replace the formula of the arc, because the formula is then a difference
// of nearly equal numbers. At this magnitude, the series is wrong by 5e-7 of the deviation b, and the formula in single
// precision by 2e-5 of b, so that both errors are below 1/64 px for deviations of up to 780 px.
const float kSmallTurn = 0.3;

// True if an arc rotates and hardly scales: the logarithm of the scale is less than 1/8 of the turn in radians. Objects with
// such paths rotate as a whole in the image plane, about one centre. With 1/4 or 1/16 in place of 1/8, the error rises by at
// most 1 % on seven scenes.
bool isTurning(vec4 curve) { return 8.0 * abs(curve.z) < abs(curve.w); }

// Deviation of a path with this curve from the straight line, px. u: 0 at shutter open, 1 at shutter close.
vec2 fromLine(vec4 curve, float u) {
  vec2 w = curve.zw;
  float x = u - 0.5;
  vec2 share;
  if (dot(w, w) < kSmallTurn * kSmallTurn) {
    vec2 w2 = complexProduct(w, w), even = vec2(1, 0) + w2 / 48.0;
    vec2 odd = complexProduct(w, vec2(1, 0) + w2 * ((x * x + 0.25) / 20.0));
    vec2 series = vec2(1, 0) + odd * (x / 3.0) + w2 * ((x * x + 0.25) / 12.0);
    share = 4.0 * u * (1.0 - u) * complexQuotient(series, even);
  } else {
    vec2 late = complexExp(0.5 * w), early = complexExp(-0.5 * w), level = 0.5 * (late + early);
    share = complexQuotient(complexExp(w * x) - level - x * (late - early), vec2(1, 0) - level);
  }
  return complexProduct(curve.xy, share);
}
#else
// Deviation of a path with this curve from the straight line, px. u: 0 at shutter open, 1 at shutter close.
vec2 fromLine(vec4 curve, float u) { return 4.0 * u * (1.0 - u) * curve.xy; }
#endif

// Screen offset from the raster time to time t of a point with the displacement d and this curve, px. d: px over the exposure.
// t: in exposures from the raster time. `shutter`: times of shutter open and shutter close.
vec2 movedBy(vec2 d, vec4 curve, float t, vec2 shutter) {
  if (curve == vec4(0)) return d * t;
  return d * t + fromLine(curve, t - shutter.x) - fromLine(curve, -shutter.x);
}

// Squared difference of two curves, px^2, to compare paths. For arcs, the difference of w is multiplied by the longer b to be a
// length.
float apartSquared(vec4 a, vec4 b) {
  if (a == b) return 0.0;
  vec4 apart = a - b;
#if ON_ARCS
  apart.zw *= max(lengthOf(a.xy), lengthOf(b.xy));
#endif
  return dot(apart, apart);
}

// Curve of a path that is scaled to `share` of its size, such as a path with a shortened displacement. `share`: 0 to 1.
vec4 shortenedCurve(vec4 curve, float share) {
#if ON_ARCS
  return vec4(curve.xy * share, curve.zw);
#else
  return curve * share;
#endif
}

// Bezier control points of a parabola: points 2 to 4 of the cubic Bezier curve, relative to point 1 (the position at shutter
// open), px. The path lies in the convex hull of the four points.
void controlPoints(vec2 d, vec4 curve, out vec2 points[3]) {
  points[0] = d / 3.0 + 4.0 / 3.0 * curve.xy;
  points[1] = 2.0 / 3.0 * d + 4.0 / 3.0 * curve.xy;
  points[2] = d;
}

#if ON_ARCS
// Result of `straightened` for an arc: corners of a box around the arc. The box contains 16 points of the arc, and is widened
// by 5/4 of the arc's largest deviation from the chords between these points.
void arcStraightened(vec2 d, vec4 curve, vec2 shutter, out vec2 around[4]) {
  const int kPlaces = 16;
  vec2 low = vec2(0), high = vec2(0), bulge = vec2(0), from = vec2(0);
  for (int i = 1; i <= kPlaces; ++i) {
    float u = float(i) / float(kPlaces);
    vec2 to = fromLine(curve, u), middle = fromLine(curve, u - 0.5 / float(kPlaces));
    low = min(low, d * u + to);
    high = max(high, d * u + to);
    bulge = max(bulge, abs(middle - 0.5 * (from + to)));
    from = to;
  }
  vec2 now = -shutter.x * d + fromLine(curve, -shutter.x);
  float far = abs(shutter.x) > abs(shutter.y) ? shutter.x : shutter.y;
  vec2 a = (low - 1.25 * bulge - now) / far, b = (high + 1.25 * bulge - now) / far;
  around = vec2[4](a, vec2(b.x, a.y), vec2(a.x, b.y), b);
}
#endif

// Four straight displacements `around`, px over the exposure, that bound a curved path, for passes that process
// straight motion only. Move a point by each displacement, from the raster time to the end of the exposure that is
// farther away: the bounding box of the four end positions contains the whole curved path. If the path is straight, all
// four displacements equal d.
void straightened(vec2 d, vec4 curve, vec2 shutter, out vec2 around[4]) {
  around = vec2[4](d, d, d, d);
  if (curve == vec4(0)) return;
#if ON_ARCS
  arcStraightened(d, curve, shutter, around);
#else
  vec2 points[3];
  controlPoints(d, curve, points);
  vec2 now = -shutter.x * d + fromLine(curve, -shutter.x);
  float far = abs(shutter.x) > abs(shutter.y) ? shutter.x : shutter.y;
  around = vec2[4](-now / far, (points[0] - now) / far, (points[1] - now) / far, (points[2] - now) / far);
#endif
}

// Length of a straight displacement that moves a surface at least as far from its position at the raster time as the path does,
// px.
float reachOf(vec2 d, vec4 curve, vec2 shutter) {
  vec2 around[4];
  straightened(d, curve, shutter, around);
  return max(max(lengthOf(around[0]), lengthOf(around[1])), max(lengthOf(around[2]), lengthOf(around[3])));
}

// Number of steps of a walk over tiles along a path: four steps for each tile side that fits into the reach of the path
// (`reachOf`), at least 4, at most 64. `tile`: side of a tile, px.
int stepsAlong(vec2 d, vec4 curve, int tile) { return clamp(int(4.0 * reachOf(d, curve, frame.shutter)) / tile, 4, 64); }

#endif
