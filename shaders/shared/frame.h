// SPDX-License-Identifier: MIT
// What every pass knows of the frame it is in.
#ifndef STROBE_SHARED_FRAME_H
#define STROBE_SHARED_FRAME_H
#include "shared/types.h"
STROBE_SHARED_BEGIN

#define ANCHOR_CLOSE 0u   // the exposure ends at the capture:      t in [-1, 0]
#define ANCHOR_CENTRE 1u  // the capture is in its middle:          t in [-1/2, 1/2]
#define ANCHOR_OPEN 2u    // the exposure starts at the capture:    t in [0, 1]

#define CURVE_KNOTS 64  // most of either half of a shutter curve

struct FrameData {
  uvec2 size;     // pixels
  vec2 subpixel;  // offset of the sample from the pixel's centre, px
  vec2 shutter;   // (open, close) relative to the capture, in exposures
  uint anchor;    // ANCHOR_*
  uint frame;     // number of the frame
  uint seed;
  uint iteration;        // of the loop a pass is in, else 0
  uint iteration_count;  // of that loop and those that share its exposure with it, else 1
  uint part;             // of as many parts of the exposure
  uint slice_count;      // scene times among which a pixel of this iteration may draw, else 1
  uint instance_count;
  uint light_count;
  vec3 sky;         // radiance from above,
  vec3 ground;      // from below
  vec4 background;  // rgb and 1 if rays that miss see this instead of the two above
  ivec4 reach;      // pixels [x, z) x [y, w) in which anything that moves can be seen
  ivec4 crossing;   // pixels in which something may be seen that is outside of the picture at the capture and the ends,
  vec2 crossing_times;  // at these times, in exposures from the capture
  float exposure;       // length of the exposure, in frames
  uint camera_rests;    // 1 where the camera surely stands still within the exposure
  uint moving_count;    // instances that may move within it
  // The shutter curve (runtime/math/shutter_curve.h), from the opening and from the closing to the middle of its
  // weight: distance from that end, share of the weight so far, weight, slope of the weight.
  uvec2 curve_counts;  // knots from either end; 0: all times count alike
  vec2 curve_sides;    // shares of the weight before and after the capture
  vec4 curve_opening[CURVE_KNOTS];
  vec4 curve_closing[CURVE_KNOTS];
};

STROBE_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(strobe::shared::FrameData) == 168 + 2 * CURVE_KNOTS * 16);
#endif
#endif
