// SPDX-License-Identifier: MIT
// Sample times of equal weight under the frame's shutter curve, for all filters (docs/exposure.md, docs/derivations.md). The
// shutter curve is the weight of each time of the exposure. Samples are denser where the weight is larger. With the curve `box`
// the times are evenly spaced. FACT_weighted is 0 if the frame has the curve `box`; the code for other curves is then not
// compiled.
// The frame stores a curve as knots with linear weights in between, in two lists: from shutter open and from shutter close,
// each to the time that halves the total weight. A symmetric curve therefore has mirrored times, bit for bit. Below, a share of
// the weight is a share of the total weight.
#ifndef STROBE_TIMES_GLSL
#define STROBE_TIMES_GLSL
#include "lib/blur.glsl"

#if FACT_weighted
bool isWeighted() { return frame.curve_counts.x > 0u; }

// Knot i of the shutter curve, counted from shutter close (if `closing`) or from shutter open. x: distance of the knot from
// that end, as a share of the exposure. y: share of the weight between that end and the knot. z: weight at the knot. w: slope
// of the weight up to the next knot.
vec4 curveKnot(bool closing, uint i) { return closing ? frame.curve_closing[i] : frame.curve_opening[i]; }

// The last knot with a distance (`what` = 0), or with a share of the curve's weight (`what` = 1), of at most `value`. Found by
// binary search.
vec4 curveKnotBefore(bool closing, int what, float value) {
  uint low = 0u, high = closing ? frame.curve_counts.y : frame.curve_counts.x;
  while (high - low > 1u) {
    uint middle = (low + high) / 2u;
    if (curveKnot(closing, middle)[what] <= value) low = middle;
    else high = middle;
  }
  return curveKnot(closing, low);
}

// Distance from shutter close (if `closing`) or shutter open, as a share of the exposure, such that `share` (at most 1/2) of
// the weight lies within this distance. The weight is linear between knots, so the distance solves a quadratic equation.
float distanceToShare(bool closing, float share) {
  vec4 knot = curveKnotBefore(closing, 1, share);
  float more = share - knot.y;
  float twice_mean = knot.z + sqrt(max(knot.z * knot.z + 2.0 * knot.w * more, 0.0));
  return more > 0.0 && twice_mean > 0.0 ? knot.x + 2.0 * more / twice_mean : knot.x;
}

// Time at the distance `away` (a share of the exposure) from shutter close (if `closing`) or shutter open, in exposures from
// the raster time.
float timeFromEnd(bool closing, float away) {
  return closing ? frame.shutter.y * (1.0 - away) + frame.shutter.x * away
                 : frame.shutter.x * (1.0 - away) + frame.shutter.y * away;
}

// Time that divides the weight into two parts. `share`: part between this time and one end of the exposure, which is shutter
// close if `closing`, otherwise shutter open. `others`: part between this time and the other end. The result is computed from
// the end with the smaller part, because the knots of an end reach only to the middle of the weight. If the parts are
// equal, the result is the mean of the results from both ends.
float timeBetween(bool closing, float share, float others) {
  if (share < others) return timeFromEnd(closing, distanceToShare(closing, share));
  if (share > others) return timeFromEnd(!closing, distanceToShare(!closing, others));
  return 0.5 * (timeFromEnd(closing, distanceToShare(closing, 0.5)) + timeFromEnd(!closing, distanceToShare(!closing, 0.5)));
}

// Distance of time t from shutter close (if `closing`) or shutter open, as a share of the exposure.
float distanceFromEnd(bool closing, float t) {
  vec2 window = frame.shutter;
  return clamp((closing ? window.y - t : t - window.x) / (window.y - window.x), 0.0, 1.0);
}

// Share of the weight within the distance `away` (a share of the exposure) from shutter close (if `closing`) or shutter open.
// The result is at most 1/2, because the knots of an end reach only to the middle of the weight. Inverse of distanceToShare.
float shareToDistance(bool closing, float away) {
  vec4 knot = curveKnotBefore(closing, 0, away);
  float more = away - knot.x;
  return min(knot.y + more * (knot.z + 0.5 * knot.w * more), 0.5);
}

// Share of the weight between time t and shutter close (if `closing`) or shutter open.
float shareFromEnd(bool closing, float t) {
  float away = distanceFromEnd(closing, t);
  uint last = (closing ? frame.curve_counts.y : frame.curve_counts.x) - 1u;
  if (away <= curveKnot(closing, last).x) return shareToDistance(closing, away);
  return 1.0 - shareToDistance(!closing, distanceFromEnd(!closing, t));
}
#endif

// Time before which the fraction part / parts of the exposure's weight lies, in exposures from the raster time.
float timeAt(float part, int parts) {
#if FACT_weighted
  if (isWeighted()) return timeBetween(false, part / float(parts), (float(parts) - part) / float(parts));
#endif
  return evenTimeAt(part, parts, frame.shutter);
}

// Time of sample i of n: the midpoint of part i of n parts of the exposure of equal weight. `jitter`: shift of the time, in
// [-1/2, 1/2] of a part.
float sampleTime(int i, int n, float jitter) { return timeAt(float(i) + 0.5 + jitter, n); }

// Index of the sample that is exactly at the raster time; -1 if no sample is there. Sample i of n is at the time before
// which the fraction (i + 1) / (n + 1) of the shutter curve's total weight lies. Only the middle sample of an exposure
// with times on both sides of the raster time can be at the raster time.
int sampleAtRasterTime(int n) {
  if (!isCentred(frame.shutter) || n % 2 == 0) return -1;
#if FACT_weighted
  if (isWeighted() && timeAt(float(n + 1) * 0.5, n + 1) != 0.0) return -1;
#endif
  return (n - 1) / 2;
}

// ---- one side of the exposure: from the raster time to shutter close (`after`) or back to shutter open

// Factor for the weight of one side of a two-sided exposure: the weight of this side, divided by half of the total
// weight. With the curve `box`, the factor is 1. An exposure with only one side needs no factor; the result is then 1.
float sideFactor(bool after) {
#if FACT_weighted
  if (isWeighted() && isCentred(frame.shutter)) return 2.0 * (after ? frame.curve_sides.y : frame.curve_sides.x);
#endif
  return 1.0;
}

// Time on one side of the exposure, such that `share` of the weight of this side lies between the raster time and this time.
float timeOutwards(bool after, float share) {
  float end = after ? frame.shutter.y : frame.shutter.x;
#if FACT_weighted
  if (isWeighted()) {
    float rest = (after ? frame.curve_sides.y : frame.curve_sides.x) * max(1.0 - share, 0.0);
    return timeBetween(after, rest, 1.0 - rest);
  }
#endif
  return end * share;
}

// Share of the weight of one side of the exposure that lies at most the time `span` (>= 0) away from the raster time. `after`:
// the side after the raster time, otherwise the side before it. Inverse of timeOutwards.
float shareWithin(bool after, float span) {
#if FACT_weighted
  if (isWeighted()) {
    float side = after ? frame.curve_sides.y : frame.curve_sides.x;
    if (side <= 0.0) return 0.0;
    return clamp(1.0 - shareFromEnd(after, after ? span : -span) / side, 0.0, 1.0);
  }
#endif
  return span / (after ? frame.shutter.y : -frame.shutter.x);
}

#endif
