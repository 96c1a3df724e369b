// SPDX-License-Identifier: MIT
// Paths over the picture that are no straight lines: polynomials of second or third order in time through poses inside of
// the exposure. With u in [0, 1] from its start to its end a point leaves the line between the ends of its path by
//   4 u (1 - u) (b + (2u - 1) c),   b = curve.xy, c = curve.zw, px;
// b is how far it is from that line in the middle, and c, by how much more on the way to the end than from the start.
// A curve of 0 is the straight line, bit for bit.
#ifndef STROBE_PATH_GLSL
#define STROBE_PATH_GLSL
#include "lib/blur.glsl"

vec2 fromLine(vec4 curve, float u) { return 4.0 * u * (1.0 - u) * (curve.xy + (2.0 * u - 1.0) * curve.zw); }

// Where what moves by d over the exposure, on that curve, is at time t, from where it is at the capture, px.
vec2 movedBy(vec2 d, vec4 curve, float t, vec2 shutter) {
  if (curve == vec4(0)) return d * t;
  return d * t + fromLine(curve, t - shutter.x) - fromLine(curve, -shutter.x);
}

// The three control points of the path as a cubic Bezier curve but the first, from where it is at the start, px: the path is
// within their hull.
void controlPoints(vec2 d, vec4 curve, out vec2 points[3]) {
  points[0] = d / 3.0 + 4.0 / 3.0 * (curve.xy - curve.zw);
  points[1] = 2.0 / 3.0 * d + 4.0 / 3.0 * (curve.xy + curve.zw);
  points[2] = d;
}

// Displacements px over the exposure that, in a straight line, come where the path's control points lie: their box holds
// it. Each is d where the curve is straight.
void straightened(vec2 d, vec4 curve, vec2 shutter, out vec2 around[4]) {
  around = vec2[4](d, d, d, d);
  if (curve == vec4(0)) return;
  vec2 points[3];
  controlPoints(d, curve, points);
  vec2 now = -shutter.x * d + fromLine(curve, -shutter.x);
  float far = abs(shutter.x) > abs(shutter.y) ? shutter.x : shutter.y;
  around = vec2[4](-now / far, (points[0] - now) / far, (points[1] - now) / far, (points[2] - now) / far);
}

// How long a straight displacement must be to reach as far, px.
float reachOf(vec2 d, vec4 curve, vec2 shutter) {
  vec2 around[4];
  straightened(d, curve, shutter, around);
  return max(max(lengthOf(around[0]), lengthOf(around[1])), max(lengthOf(around[2]), lengthOf(around[3])));
}

#endif
