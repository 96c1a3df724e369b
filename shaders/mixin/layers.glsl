// SPDX-License-Identifier: MIT
// Needs: color_tex, params.limit, revealed_color_tex, revealed_depth_tex, revealed_valid_tex, revealed_velocity_tex,
//   velocity_tex; may have: PARAM_trajectory, after_velocity_tex, close_color_tex, close_curve_tex, close_depth_tex,
//   close_valid_tex, close_velocity_tex, curve_tex, dominant_curve_tex, open_color_tex, open_curve_tex,
//   open_depth_tex, open_valid_tex, open_velocity_tex, reach_tex, revealed_2_after_velocity_tex,
//   revealed_2_color_tex, revealed_2_curve_tex, revealed_2_depth_tex, revealed_2_valid_tex, revealed_2_velocity_tex,
//   revealed_3_after_velocity_tex, revealed_3_color_tex, revealed_3_curve_tex, revealed_3_depth_tex,
//   revealed_3_valid_tex, revealed_3_velocity_tex, revealed_4_after_velocity_tex, revealed_4_color_tex,
//   revealed_4_curve_tex, revealed_4_depth_tex, revealed_4_valid_tex, revealed_4_velocity_tex,
//   revealed_after_velocity_tex, revealed_curve_tex.
// The layers that a composite chooses from, by number: what raster saw, what was revealed behind it, what the ends of the
// exposure alone see. Raster is everywhere; the others hold something here and there.
#ifndef STROBE_LAYERS_GLSL
#define STROBE_LAYERS_GLSL
#include "mixin/path.glsl"
#include "lib/sanitise.glsl"

// What is at a pixel at some time: nothing, what raster saw, the first, second ... surface revealed behind it, or what an end
// of the exposure alone sees.
const int kNothing = 0, kRaster = 1, kRevealed = 2, kOpenEnd = 6, kCloseEnd = 7;
#if defined(HAS_revealed_2_valid)
const int kLastRevealed = kRevealed + HAS_revealed_2_valid + HAS_revealed_3_valid + HAS_revealed_4_valid;
#else
const int kLastRevealed = kRevealed;
#endif

bool isHeld(int layer, ivec2 pixel) {
#if HAS_open_valid
  if (layer == kOpenEnd) return texelFetch(open_valid_tex, pixel, 0).x > 0.5;
#endif
#if HAS_close_valid
  if (layer == kCloseEnd) return texelFetch(close_valid_tex, pixel, 0).x > 0.5;
#endif
#if HAS_revealed_2_valid
  if (layer == kRevealed + 1) return texelFetch(revealed_2_valid_tex, pixel, 0).x > 0.5;
#endif
#if HAS_revealed_3_valid
  if (layer == kRevealed + 2) return texelFetch(revealed_3_valid_tex, pixel, 0).x > 0.5;
#endif
#if HAS_revealed_4_valid
  if (layer == kRevealed + 3) return texelFetch(revealed_4_valid_tex, pixel, 0).x > 0.5;
#endif
  return texelFetch(revealed_valid_tex, pixel, 0).x > 0.5;
}

// Is there a texel of a layer, that holds something?
bool holds(int layer, ivec2 texel) {
  return isInside(texel, textureSize(color_tex, 0)) && (layer == kRaster || isHeld(layer, texel));
}

float depthOf(int layer, ivec2 pixel) {
#if HAS_open_depth
  if (layer == kOpenEnd) return saneDepth(texelFetch(open_depth_tex, pixel, 0).x);
#endif
#if HAS_close_depth
  if (layer == kCloseEnd) return saneDepth(texelFetch(close_depth_tex, pixel, 0).x);
#endif
#if HAS_revealed_2_depth
  if (layer == kRevealed + 1) return saneDepth(texelFetch(revealed_2_depth_tex, pixel, 0).x);
#endif
#if HAS_revealed_3_depth
  if (layer == kRevealed + 2) return saneDepth(texelFetch(revealed_3_depth_tex, pixel, 0).x);
#endif
#if HAS_revealed_4_depth
  if (layer == kRevealed + 3) return saneDepth(texelFetch(revealed_4_depth_tex, pixel, 0).x);
#endif
  return saneDepth(texelFetch(revealed_depth_tex, pixel, 0).x);
}

// How paths are curved.
vec4 curveAt(int layer, ivec2 pixel) {
#if HAS_curve
  if (layer == kRaster) return texelFetch(curve_tex, pixel, 0);
#endif
#if HAS_open_curve
  if (layer == kOpenEnd) return texelFetch(open_curve_tex, pixel, 0);
#endif
#if HAS_close_curve
  if (layer == kCloseEnd) return texelFetch(close_curve_tex, pixel, 0);
#endif
#if HAS_revealed_2_curve
  if (layer == kRevealed + 1) return texelFetch(revealed_2_curve_tex, pixel, 0);
#endif
#if HAS_revealed_3_curve
  if (layer == kRevealed + 2) return texelFetch(revealed_3_curve_tex, pixel, 0);
#endif
#if HAS_revealed_4_curve
  if (layer == kRevealed + 3) return texelFetch(revealed_4_curve_tex, pixel, 0);
#endif
#if HAS_revealed_curve
  if (layer == kRevealed) return texelFetch(revealed_curve_tex, pixel, 0);
#endif
  return vec4(0);
}

// Displacements of the layers in the part of the exposure after the capture, or before it.
vec4 displacementAt(ivec2 pixel, bool after) {
#if HAS_after_velocity
  if (after) return texelFetch(after_velocity_tex, pixel, 0);
#endif
  return texelFetch(velocity_tex, pixel, 0);
}

vec4 heldDisplacementAt(int layer, ivec2 pixel, bool after) {
#if HAS_open_velocity
  if (layer == kOpenEnd) return texelFetch(open_velocity_tex, pixel, 0);
#endif
#if HAS_close_velocity
  if (layer == kCloseEnd) return texelFetch(close_velocity_tex, pixel, 0);
#endif
#if HAS_revealed_2_after_velocity
  if (after && layer == kRevealed + 1) return texelFetch(revealed_2_after_velocity_tex, pixel, 0);
#endif
#if HAS_revealed_3_after_velocity
  if (after && layer == kRevealed + 2) return texelFetch(revealed_3_after_velocity_tex, pixel, 0);
#endif
#if HAS_revealed_4_after_velocity
  if (after && layer == kRevealed + 3) return texelFetch(revealed_4_after_velocity_tex, pixel, 0);
#endif
#if HAS_revealed_after_velocity
  if (after) return texelFetch(revealed_after_velocity_tex, pixel, 0);
#endif
#if HAS_revealed_2_velocity
  if (layer == kRevealed + 1) return texelFetch(revealed_2_velocity_tex, pixel, 0);
#endif
#if HAS_revealed_3_velocity
  if (layer == kRevealed + 2) return texelFetch(revealed_3_velocity_tex, pixel, 0);
#endif
#if HAS_revealed_4_velocity
  if (layer == kRevealed + 3) return texelFetch(revealed_4_velocity_tex, pixel, 0);
#endif
  return texelFetch(revealed_velocity_tex, pixel, 0);
}

Path pathOf(int layer, ivec2 pixel, bool after) {
  vec4 d = layer == kRaster ? displacementAt(pixel, after) : heldDisplacementAt(layer, pixel, after);
  return limitedPath(d, curveAt(layer, pixel));
}

vec3 colorOf(int layer, ivec2 now) {
  if (layer == kRaster) return finiteColor(texelFetch(color_tex, now, 0));
#if HAS_open_color
  if (layer == kOpenEnd) return finiteColor(texelFetch(open_color_tex, now, 0));
#endif
#if HAS_close_color
  if (layer == kCloseEnd) return finiteColor(texelFetch(close_color_tex, now, 0));
#endif
#if HAS_revealed_2_color
  if (layer == kRevealed + 1) return finiteColor(texelFetch(revealed_2_color_tex, now, 0));
#endif
#if HAS_revealed_3_color
  if (layer == kRevealed + 2) return finiteColor(texelFetch(revealed_3_color_tex, now, 0));
#endif
#if HAS_revealed_4_color
  if (layer == kRevealed + 3) return finiteColor(texelFetch(revealed_4_color_tex, now, 0));
#endif
  return finiteColor(texelFetch(revealed_color_tex, now, 0));
}

// The time from when a layer has things where they are to t, both in exposures from the capture.
float timeFrom(int layer, float t) {
#if HAS_open_valid || HAS_close_valid
  return layer == kOpenEnd ? t - frame.shutter.x : layer == kCloseEnd ? t - frame.shutter.y : t;
#else
  return t;
#endif
}

// The window of the exposure from then.
vec2 windowFrom(int layer) { return vec2(timeFrom(layer, frame.shutter.x), timeFrom(layer, frame.shutter.y)); }

#endif
