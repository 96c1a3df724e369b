// SPDX-License-Identifier: MIT
// Boxes of displacements: (least x, least y, greatest x, greatest y), px over the exposure. The box of a cell contains the
// displacements of all its pixels. A filter can skip a cell if the box proves that no surface in it affects the pixel.
#ifndef STROBE_BOUNDS_GLSL
#define STROBE_BOUNDS_GLSL
#include "lib/blur.glsl"

// Empty box: its union with another box is that box.
const vec4 kNoBounds = vec4(1e30, 1e30, -1e30, -1e30);

vec2 lowOf(vec4 bounds) { return vec2(bounds.x, bounds.y); }

vec2 highOf(vec4 bounds) { return vec2(bounds.z, bounds.w); }

bool isEmpty(vec4 bounds) { return bounds.x > bounds.z; }

// Length of the longest displacement in the box, px.
float longestIn(vec4 bounds) { return lengthOf(max(abs(lowOf(bounds)), abs(highOf(bounds)))); }

// Length of the shortest displacement in the box, px.
float shortestIn(vec4 bounds) { return lengthOf(clamp(vec2(0), lowOf(bounds), highOf(bounds))); }

// Box of the differences d - of, for all displacements d in the box.
vec4 relativeTo(vec4 bounds, vec2 of) { return bounds - vec4(of, of); }

// Length of the longest difference between a displacement in one box and a displacement in the other, px.
float farthestApart(vec4 a, vec4 b) { return lengthOf(max(abs(highOf(a) - lowOf(b)), abs(highOf(b) - lowOf(a)))); }

// Box of the offsets that surfaces reach within the exposure window `shutter`, from their places at the raster time, for all
// displacements in the box `bounds`, px. The box of offsets contains 0.
vec4 travelled(vec4 bounds, vec2 shutter) {
  vec4 earliest = bounds * shutter.x, latest = bounds * shutter.y;
  vec2 low = min(min(lowOf(earliest), highOf(earliest)), min(lowOf(latest), highOf(latest)));
  vec2 high = max(max(lowOf(earliest), highOf(earliest)), max(lowOf(latest), highOf(latest)));
  return vec4(min(low, vec2(0)), max(high, vec2(0)));
}

#endif
