// SPDX-License-Identifier: MIT
// Data of the frame, available to every pass.
#ifndef STROBE_SHARED_FRAME_H
#define STROBE_SHARED_FRAME_H
#include "shared/types.h"
STROBE_SHARED_BEGIN

#define ANCHOR_END 0u   // the exposure ends at the raster time:           t in [-1, 0]
#define ANCHOR_CENTRE 1u  // the raster time is in the exposure's middle:    t in [-1/2, 1/2]
#define ANCHOR_START 2u    // the exposure starts at the raster time:         t in [0, 1]

#define CURVE_KNOTS 64  // largest number of knots in each half of a shutter curve

struct FrameData {
  uvec2 size;     // pixels
  vec2 subpixel;  // offset of the sample from the pixel's centre, px
  vec2 shutter;   // (shutter open, shutter close) relative to the raster time, in exposures
  uint anchor;    // ANCHOR_*
  uint frame;     // number of the frame
  uint seed;
  uint iteration;        // of the loop that the pass is in; 0 outside of loops
  uint iteration_count;  // of this loop and of all loops that sample the same exposure; 1 outside of loops
  uint part;             // number of the exposure's part that the iteration samples, below `iteration_count`
  uint slice_count;      // scene times among which each pixel of this iteration can choose; 1 outside of loops
  uint instance_count;
  uint light_count;
  vec3 sky;         // ambient radiance from above
  vec3 ground;      // ambient radiance from below
  vec4 background;  // rgb: radiance of rays that miss, if w is 1; if w is 0, these rays get sky and ground
  ivec4 moving_rect;      // pixels [x, z) x [y, w) that moving surfaces can reach in the exposure; conservative
  ivec4 crossing;   // pixels [x, z) x [y, w) that may show an object that is outside at raster time, shutter open and close
  vec2 crossing_times;  // first and last time when such an object is visible, in exposures from the raster time
  float exposure;       // length of the exposure, in frames
  uint camera_rests;    // 1 if the camera is proven static within the exposure
  uint moving_count;    // number of instances that may move within the exposure
  // The shutter curve (runtime/math/shutter_curve.h), from shutter open and from shutter close to the middle of the curve's
  // weight. x of a knot: distance from that end; y: share of the weight up to the knot; z: weight; w: slope of the weight.
  uvec2 curve_counts;  // number of knots from shutter open, from shutter close; 0: all times have equal weight
  vec2 curve_sides;    // shares of the weight before and after the raster time
  vec4 curve_opening[CURVE_KNOTS];
  vec4 curve_closing[CURVE_KNOTS];
};

STROBE_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(strobe::shared::FrameData) == 168 + 2 * CURVE_KNOTS * 16);
#endif
#endif
