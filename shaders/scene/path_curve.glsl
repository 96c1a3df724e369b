// SPDX-License-Identifier: MIT
// How a layer's paths are curved: polynomials of second or third order (lib/path.glsl) through poses inside of the exposure,
// and what these do not say. In a loop of three times: at 1/6, 1/2 and 5/6 of the exposure.
// In:  depth, id, velocity, hit, normal as path_bend has them.
// Out: curve (px: of second order the first two, of third order all four), bend (px: how far the path is from the line between
//      its ends in the middle), bent (1 where the curve is farther than `most_bend` px from the path at one of the times, or
//      a pixel grows to more than `most_growth` px).
// The second order meets the path in the middle; the third order takes from the other two times by how much more it is off
// the line late than early, which leaves what both have in common to `bent`.
// Fails: of a full turn three poses see a third each: what turns by more than half a turn is `bent`.
#include "mixin/stored.glsl"
#include "mixin/texel_path.glsl"
#include "lib/path.glsl"

const float kTimes[3] = float[3](1.0 / 6.0, 0.5, 5.0 / 6.0);

void run(ivec2 pixel) {
  uint id = texelFetch(id_tex, pixel, 0).x, kind = pathKind(id);
  vec4 curve = vec4(0);
  float off_px = 0.0;
  bool grows = false;
  if (isMoving(pixel)) {
    if ((kind & PATH_CURVED) != 0u) {
      vec2 open = pathOfTexel(SLICE_OPEN, pixel), close = pathOfTexel(SLICE_CLOSE, pixel), from_line[3];
      for (uint k = 0u; k < 3u; ++k) from_line[k] = pathOfTexel(SLICE_SAMPLE + k, pixel) - mix(open, close, kTimes[k]);
      curve.xy = from_line[1];
#if PARAM_trajectory == trajectory_cubic
      curve.zw = 27.0 / 20.0 * (from_line[2] - from_line[0]);
#endif
      for (int k = 0; k < 3; ++k) off_px = max(off_px, lengthOf(from_line[k] - fromLine(curve, kTimes[k])));
    }
    if ((kind & PATH_TURNS) != 0u) grows = growsAt(pixel, id);
  }
  imageStore(curve_img, pixel, curve);
  imageStore(bend_img, pixel, vec4(storedVelocity(curve.xy), 0, 0));
  imageStore(bent_img, pixel, vec4(!(off_px <= params.most_bend) || grows ? 1 : 0));
}
