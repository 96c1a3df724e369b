// SPDX-License-Identifier: MIT
// Fits parabolas or arcs (mixin/curve.glsl) to the paths of a layer's points, through true poses inside the exposure.
// In:  `depth`: view depth, metres; +inf for the sky, 0 where the layer has no surface
//      `id`: instance + 1; 0 for the sky
//      `velocity`: displacement, px over the exposure
//      `hit`: instance + 1, geometry, primitive; absent: deformation by joints and morph targets is ignored
//      `normal`: unit normal in world space; absent: `max_stretch` is not tested
// Out: `curve`: xy: path deviation in the middle of the exposure, px; zw: for an arc, logarithm of the growth factor and turn
//        in radians, over the exposure
//      `path_deviation`: path deviation in the middle of the exposure, px
//      `nonlinear`: 1 if the path is more than `max_deviation` px from the curve at a time of the loop, or if two points one
//        pixel apart at the raster time are more than `max_stretch` px apart at shutter open or close
// Method: pose the point at shutter open, at shutter close and at the times of the loop: three times for parabolas, at 1/6, 1/2
//   and 5/6 of the exposure, and five for arcs, at 1/10, 3/10, 5/10, 7/10 and 9/10. Both kinds of curve meet the path at both
//   ends and in the middle. On an arc, the second differences of the positions rotate and grow as the arc does, for any centre
//   and any linear motion of the centre. The quotient of two second differences, as complex numbers, therefore gives turn and
//   growth.
// Fails: parabolas fail beyond a sixth of a turn, arcs beyond one and a quarter turns. A circle seen obliquely fits neither.
#include "mixin/quantised.glsl"
#include "mixin/texel_path.glsl"
#include "mixin/curve.glsl"

const int kPoses = PARAM_trajectory == trajectory_arc ? 5 : 3;

// Time of pose k of the loop, as a share of the exposure from shutter open.
float timeOfPose(int k) { return (float(k) + 0.5) / float(kPoses); }

#if ON_ARCS
// Limits of an arc. Beyond each limit the curve is a parabola.
// kLeastDifference: shortest second difference that exceeds rounding errors, px; about four float spacings at 2048 to 4096 px.
// kMaxStretch: largest logarithm of a growth factor over the exposure (e^4 = 55); not derived.
// kMostTurn: largest turn, radians. The two second differences are 0.4 of the exposure apart, so turns are unique below pi /
// 0.4 = 7.85. The value is 2 % less, so that rounding cannot reverse the sign.
const float kLeastDifference = 1e-3, kMaxStretch = 4.0, kMostTurn = 7.7;

// Logarithm of the growth factor (x) and turn in radians (y) over the exposure, of a path that is an arc; 0 if the path is not
// an arc. `places`: positions of the point at the five times, px.
vec2 turnOf(vec2 places[kPoses]) {
  vec2 early = places[0] - 2.0 * places[1] + places[2], late = places[2] - 2.0 * places[3] + places[4];
  if (min(lengthOf(early), lengthOf(late)) < kLeastDifference) return vec2(0);
  vec2 change = complexQuotient(late, early);
  vec2 turn = vec2(log(lengthOf(change)), atan(change.y, change.x)) / (timeOfPose(3) - timeOfPose(1));
  return abs(turn.x) <= kMaxStretch && abs(turn.y) <= kMostTurn ? turn : vec2(0);
}
#endif

void run(ivec2 pixel) {
  uint id = texelFetch(id_tex, pixel, 0).x, kind = pathKind(id);
  vec4 curve = vec4(0);
  float off_px = 0.0;
  bool grows = false;
  bool is_curved = (kind & PATH_CURVED) != 0u && texelFetch(depth_tex, pixel, 0).x > 0.0;
  if (is_curved || isMoving(pixel)) {
    if (is_curved) {
      vec2 open = vec2(0), close = vec2(0), from_line[kPoses];
      for (int k = -2; k < kPoses; ++k) {
        vec2 path = pathOfTexel(k == -2 ? SLICE_SHUTTER_OPEN : k == -1 ? SLICE_SHUTTER_CLOSE : SLICE_SAMPLE + uint(k), pixel);
        if (k == -2) open = path;
        else if (k == -1) close = path;
        else from_line[k] = path - mix(open, close, timeOfPose(k));
      }
      curve.xy = from_line[kPoses / 2];
#if ON_ARCS
      curve.zw = turnOf(from_line);
#endif
      for (int k = 0; k < kPoses; ++k) off_px = max(off_px, lengthOf(from_line[k] - fromLine(curve, timeOfPose(k))));
    }
    if ((kind & PATH_TURNS) != 0u) grows = growsAt(pixel, id);
  }
  imageStore(curve_img, pixel, curve);
  imageStore(path_deviation_img, pixel, vec4(quantisedVelocity(curve.xy), 0, 0));
  imageStore(nonlinear_img, pixel, vec4(!(off_px <= params.max_deviation) || grows ? 1 : 0));
}
