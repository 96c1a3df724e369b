// SPDX-License-Identifier: MIT
// Needs: PARAM_directions, color_tex, depth_tex, params.limit, params.samples, velocity_tex; may have:
//   behind_depth_tex, behind_valid_tex, reach_tex, second_tex, valid_tex.
// The second direction along which a gather looks. Guertin, McGuire and Nowrouzezahrai 2014, "A Fast and Stable
// Feature-Aware Motion Blur Filter", section 3. `second` is what else moves around, px over the exposure, per tile.
#ifndef STROBE_DIRECTIONS_GLSL
#define STROBE_DIRECTIONS_GLSL
#include "mixin/layer.glsl"

// A displacement whose component along the perpendicular is shorter than this (px) says nothing of its side.
const float kNoSide = 1.0 / 64.0;

vec2 unitOf(vec2 d) {
  float d_length = lengthOf(d);
  return d_length > 0.0 ? d / d_length : vec2(0);
}

// Unit length, or 0. `own` is the displacement of the pixel's surface, `radius_px` how far it spreads. A pixel at rest
// looks perpendicular to the dominant displacement, one that spreads by gamma_px + 1/2 or more along its own, those
// between in between. The perpendicular is taken to the side of `own`, or, where that has none, of `other`: what else
// moves around here. Where neither tells there is none: nothing is known to move across. (The paper leaves the side to
// rounding then. A gather to one side only would look the wrong way half of the time, and mirrored scenes would not
// give mirrored pictures.)
vec2 secondDirection(vec2 dominant, vec2 own, vec2 other, float radius_px, float gamma_px) {
  vec2 across = unitOf(vec2(-dominant.y, dominant.x));
  float side = dot(across, own);
  if (abs(side) < kNoSide) side = dot(across, other);
  if (abs(side) < kNoSide) side = 0.0;
  float along_own = clamp((radius_px - 0.5) / gamma_px, 0.0, 1.0);
  return unitOf(mix(sign(side) * across, unitOf(own), along_own));
}

// The second direction at a pixel of a tile.
vec2 secondAt(ivec2 pixel, ivec2 tile, vec2 dominant, float radius_px, float gamma_px) {
  vec2 other = vec2(0);
#if HAS_second
  other = vec2(texelFetch(second_tex, tile, 0));
#endif
  return secondDirection(dominant, texelAt(pixel).d, other, radius_px, gamma_px);
}

// Is sample i of N taken along the second direction? Counted from the tap nearest to the pixel where all lie to one
// side: the anchor `open` is `close` backwards. count = N/2 takes every other one, from the second on: of an odd N
// these are the same counted from either end.
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
