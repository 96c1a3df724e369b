// SPDX-License-Identifier: MIT
// Paths of a layer as parabolas or arcs (mixin/curve.glsl) through poses inside the exposure. Runs in a loop of three times, at
// 1/6, 1/2 and 5/6 of the exposure. Arcs use five times, at 1/10, 3/10, 5/10, 7/10 and 9/10.
// In:  depth, id, velocity, hit, normal as in scene/path_bend.glsl.
// Out: curve (px; of arcs px and a turn), bend (px: distance of the path from the line between its ends in the middle of the
//      exposure), bent (1 where the curve is farther than `most_bend` px from the path at one of the times, or a pixel grows to
//      more than `most_growth` px).
// Method: a parabola meets the path in the middle. Second differences of the places on an arc turn and grow as the arc does,
// whatever its centre and the line of the centre: two of them give the turn.
// Fails: a turn beyond half a turn, for parabolas, or one and a quarter turns, for arcs; circles seen aslant.
#include "mixin/stored.glsl"
#include "mixin/texel_path.glsl"
#include "mixin/curve.glsl"

const int kPoses = PARAM_trajectory == trajectory_arc ? 5 : 3;

float timeOfPose(int k) { return (float(k) + 0.5) / float(kPoses); }

#if ON_ARCS
// Second differences below are rounding, px; beyond, a factor over the exposure is (its logarithm); turns nearly as large
// as two poses can tell may be what turns the other way, radians.
const float kLeastDifference = 1e-3, kMostGrowth = 4.0, kMostTurn = 7.7;

// By how much a path turns and grows over the exposure, of its places at the five times.
vec2 turnOf(vec2 places[kPoses]) {
  vec2 early = places[0] - 2.0 * places[1] + places[2], late = places[2] - 2.0 * places[3] + places[4];
  if (min(lengthOf(early), lengthOf(late)) < kLeastDifference) return vec2(0);
  vec2 change = complexQuotient(late, early);
  vec2 turn = vec2(log(lengthOf(change)), atan(change.y, change.x)) / (timeOfPose(3) - timeOfPose(1));
  return abs(turn.x) <= kMostGrowth && abs(turn.y) <= kMostTurn ? turn : vec2(0);
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
        vec2 path = pathOfTexel(k == -2 ? SLICE_OPEN : k == -1 ? SLICE_CLOSE : SLICE_SAMPLE + uint(k), pixel);
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
  imageStore(bend_img, pixel, vec4(storedVelocity(curve.xy), 0, 0));
  imageStore(bent_img, pixel, vec4(!(off_px <= params.most_bend) || grows ? 1 : 0));
}
