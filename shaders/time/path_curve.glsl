// SPDX-License-Identifier: MIT
// Fits parabolas or arcs (mixin/curve.glsl) to the paths of a layer's points, through true poses inside the exposure.
// In:  `depth`: view depth, metres; +inf for the sky, 0 where the layer has no surface
//      `id`: instance + 1; 0 for the sky
//      `hit`: instance + 1, geometry, primitive; absent: deformation by joints and morph targets is ignored
// Out: `curve`: xy: path deviation in the middle of the exposure, px; zw: for an arc, logarithm of the growth factor and turn
//        in radians, over the exposure
// Method: pose the point at shutter open, at shutter close and at the times of the loop: three times for parabolas, at 1/6, 1/2
//   and 5/6 of the exposure, and five for arcs, at 1/10, 3/10, 5/10, 7/10 and 9/10. Both kinds of curve meet the path at both
//   ends and in the middle. On an arc, the second differences of the positions rotate and grow as the arc does, for any centre
//   and any linear motion of the centre. The quotient of two second differences, as complex numbers, therefore gives turn and
//   growth.
// Fails: parabolas fail beyond a sixth of a turn, arcs beyond one and a quarter turns. A circle seen obliquely fits neither.
#include "mixin/texel_path.glsl"
#include "mixin/curve.glsl"

const int kPoses = PARAM_trajectory == trajectory_arc ? 5 : 3;

// Time of pose k of the loop, as a share of the exposure from shutter open.
float timeOfPose(int k) { return (float(k) + 0.5) / float(kPoses); }

#if ON_ARCS
// Limits of an arc. Beyond each limit the curve is a parabola.
// kLeastDifference: shortest second difference that exceeds rounding errors, px; about four float spacings at 2048 to 4096 px.
// kMostGrowth: largest logarithm of a growth factor over the exposure. mixin/curve.glsl computes with numbers up to the growth
// factor; e^80 = 6e34 is below the largest float, 3e38.
// kMostTurn: largest turn, radians. The two second differences are 0.4 of the exposure apart, so turns are unique below pi /
// 0.4 = 7.85. The value is 2 % less, so that rounding cannot reverse the sign.
const float kLeastDifference = 1e-3, kMostGrowth = 80.0, kMostTurn = 7.7;

// Logarithm of the growth factor (x) and turn in radians (y) over the exposure, of a path that is an arc; 0 if the path is not
// an arc. `places`: positions of the point at the five times, px.
vec2 turnOf(vec2 places[kPoses]) {
  vec2 early = places[0] - 2.0 * places[1] + places[2], late = places[2] - 2.0 * places[3] + places[4];
  if (min(lengthOf(early), lengthOf(late)) < kLeastDifference) return vec2(0);
  vec2 change = complexQuotient(late, early);
  vec2 turn = vec2(log(lengthOf(change)), atan(change.y, change.x)) / (timeOfPose(3) - timeOfPose(1));
  return abs(turn.x) <= kMostGrowth && abs(turn.y) <= kMostTurn ? turn : vec2(0);
}
#endif

void run(ivec2 pixel) {
  vec4 curve = vec4(0);
  if (isCurvedAt(pixel, texelFetch(id_tex, pixel, 0).x)) {
    vec2 open = pathOfTexel(SLICE_SHUTTER_OPEN, pixel), close = pathOfTexel(SLICE_SHUTTER_CLOSE, pixel), from_line[kPoses];
    for (int k = 0; k < kPoses; ++k) {
      from_line[k] = pathOfTexel(SLICE_SAMPLE + uint(k), pixel) - mix(open, close, timeOfPose(k));
    }
    curve.xy = from_line[kPoses / 2];
#if ON_ARCS
    curve.zw = turnOf(from_line);
#endif
  }
  imageStore(curve_img, pixel, curve);
}
