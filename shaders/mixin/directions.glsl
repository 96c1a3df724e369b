// SPDX-License-Identifier: MIT
// Needs: PARAM_directions, color_tex, depth_tex, params.limit, params.samples, velocity_tex, background_depth_tex,
//   background_valid_tex, second_tex, valid_tex; may have: max_displacement_buf, max_displacement_post_buf,
//   revealed_max_displacement_buf, revealed_max_displacement_post_buf.
// Second direction of a gather (Guertin, McGuire and Nowrouzezahrai 2014, "A Fast and Stable Feature-Aware Motion Blur Filter",
// section 3). The gather takes some of its taps along the dominant displacement of the tile, and the others along the second
// direction, which may be different at each pixel.
// In:  `second`: per tile, a displacement in the neighbourhood that differs from the dominant one, px over the exposure.
#ifndef STROBE_DIRECTIONS_GLSL
#define STROBE_DIRECTIONS_GLSL
#include "mixin/layer.glsl"

// Least length, px, of a displacement's component perpendicular to the dominant displacement. Only from this length on,
// the component decides if the displacement points to the left or to the right of the dominant displacement. Shorter
// components may be rounding errors. Halving or doubling this bound changes no pixel of six scenes.
const float kNoSide = 1.0 / 64.0;

// Unit vector along d; 0 if d is 0.
vec2 unitOf(vec2 d) {
  float d_length = lengthOf(d);
  return d_length > 0.0 ? d / d_length : vec2(0);
}

// Second direction, a unit vector or 0. `dominant`: dominant displacement. `own`: displacement of the pixel's surface. `other`:
// another displacement in the neighbourhood; all three px over the exposure. `radius_px`: blur radius of the pixel's surface.
// `gamma_px`: width of the range of blur radii with a blend of two directions, px, above 0.
// If the blur radius is at most 1/2 px (a static surface), the direction is perpendicular to the dominant displacement. From
// gamma_px + 1/2 px on, the direction is along `own`. Radii in between give a blend of both directions.
// Of the two opposite perpendiculars, the one with a positive dot product with `own` is taken. If `own` is parallel to
// `dominant` or 0, the dot product with `other` decides. If `other` is parallel or 0 too, the perpendicular is 0,
// because then no surface is known to move across the dominant displacement. (Guertin et al. leave the sign to rounding
// in this case. A one-sided gather would then sample the wrong side half of the time, and mirrored scenes would not
// give mirrored images.)
vec2 secondDirection(vec2 dominant, vec2 own, vec2 other, float radius_px, float gamma_px) {
  vec2 across = unitOf(vec2(-dominant.y, dominant.x));
  float side = dot(across, own);
  if (abs(side) < kNoSide) side = dot(across, other);
  if (abs(side) < kNoSide) side = 0.0;
  float along_own = clamp((radius_px - 0.5) / gamma_px, 0.0, 1.0);
  return unitOf(mix(sign(side) * across, unitOf(own), along_own));
}

// Second direction at a pixel that gathers along `dominant`, the dominant displacement of `tile`; a unit vector or 0.
// `radius_px`: blur radius of the pixel's surface. `gamma_px`: as in `secondDirection`.
vec2 secondAt(ivec2 pixel, ivec2 tile, vec2 dominant, float radius_px, float gamma_px) {
  return secondDirection(dominant, texelAt(pixel).d, vec2(second_at(tile)), radius_px, gamma_px);
}

// True if sample i is taken along the second direction: `count` of the N = params.samples samples, evenly spread. With
// count = N/2 these are the second, fourth, ... sample. Always false if the parameter `directions` is not `two`.
// Sample 0 has the latest time. It is the nearest tap with the anchor `end`, and the farthest tap with `start`. With
// `start`, i is therefore reversed: samples are counted from the nearest tap in both cases, so that a reversed exposure
// takes the same taps. With the anchor `centre`, samples are counted from the latest time. If N is odd and count = N/2
// (rounded down), counting from the earliest time would give the same samples.
bool isAlongSecond(int i, int count) {
#if PARAM_directions == directions_two
  if (frame.shutter.x >= 0.0) i = params.samples - 1 - i;
  int rounding = (params.samples - 1) / 2;
  return ((i + 1) * count + rounding) / params.samples > (i * count + rounding) / params.samples;
#else
  return false;
#endif
}

#endif
