// SPDX-License-Identifier: MIT
// Data of the current frame, which every pass reads as `frame`. Times are in exposures relative to the raster time, unless
// stated otherwise.
#ifndef STROBE_SHARED_FRAME_H
#define STROBE_SHARED_FRAME_H
#include "shared/types.h"
STROBE_SHARED_BEGIN

// Start and end of the exposure relative to the raster time (t = 0). The unit of t is the length of the exposure.
#define ANCHOR_END 0u     // the exposure ends at the raster time: t in [-1, 0]
#define ANCHOR_CENTRE 1u  // the raster time is in the middle of the exposure: t in [-1/2, 1/2]
#define ANCHOR_START 2u   // the exposure starts at the raster time: t in [0, 1]

#define CURVE_KNOTS 64  // largest number of knots in each half of a shutter curve

// Members of `frame`. Rectangles are half-open ranges of pixels: x <= pixel x < z, y <= pixel y < w.
struct FrameData {
  uvec2 size;            // size of the frame, pixels
  vec2 subpixel;         // offset of the sampled position from each pixel's centre, px
  vec2 shutter;          // times of shutter open and shutter close: (-1, 0), (-1/2, 1/2) or (0, 1), by the anchor
  uint anchor;           // position of the exposure relative to the raster time: ANCHOR_*
  uint frame;            // number of the frame
  uint seed;             // seed of the random numbers
  uint iteration;        // number of the iteration, counted over all loops of this exposure; 0 outside of loops
  uint iteration_count;  // number of these iterations; 1 outside of loops
  uint part;             // index of the part of the exposure that the iteration samples, from 0 to iteration_count - 1
  uint slice_count;      // number of scene times (slices) of this iteration of a loop, each for any pixel; 1 outside of loops
  uint instance_count;   // number of instances in the scene
  uint light_count;      // number of lights in the scene
  vec3 sky;              // ambient radiance from straight above, linear
  vec3 ground;           // ambient radiance from straight below, linear
  vec4 background;    // rgb: linear radiance of rays that leave the scene; if w is 0, a blend of sky and ground is used instead
  ivec4 moving_rect;  // rectangle that contains all moving surfaces at all times of the exposure; conservative
  float exposure;     // length of the exposure, in frames
  uint camera_rests;  // 1 if the camera is proven static within the exposure
  uint moving_count;  // number of instances that may move within the exposure
  // The shutter curve (runtime/math/shutter_curve.h), in two halves: from shutter open and from shutter close to the time that
  // divides the weight in two. Each half is a list of knots. x: distance of the knot from that end, as a share of the exposure.
  // y: share of the weight up to the knot. z: weight at the knot (mean 1). w: slope of the weight up to the next knot.
  uvec2 curve_counts;  // numbers of knots: x of the half from shutter open, y from shutter close; 0: all weights equal
  vec2 curve_sides;    // shares of the weight before (x) and after (y) the raster time
  vec4 curve_opening[CURVE_KNOTS];  // knots of the half from shutter open
  vec4 curve_closing[CURVE_KNOTS];  // knots of the half from shutter close
};

STROBE_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(strobe::shared::FrameData) == 144 + 2 * CURVE_KNOTS * 16);
#endif
#endif
