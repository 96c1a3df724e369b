// SPDX-License-Identifier: MIT
// Bounds of displacements as boxes: (least x, least y, greatest x, greatest y), px over the exposure. The box of a cell
// contains the displacements of all its pixels. A filter can skip a cell if the box proves that no surface in the cell affects
// the pixel.
#ifndef STROBE_BOUNDS_GLSL
#define STROBE_BOUNDS_GLSL
#include "lib/blur.glsl"

// Empty box: its union with another box is the other box.
const vec4 kNoBounds = vec4(1e30, 1e30, -1e30, -1e30);

vec2 lowOf(vec4 bounds) { return vec2(bounds.x, bounds.y); }

vec2 highOf(vec4 bounds) { return vec2(bounds.z, bounds.w); }

bool isEmpty(vec4 bounds) { return bounds.x > bounds.z; }

// Length of the longest displacement in the box, px.
float longestIn(vec4 bounds) { return lengthOf(max(abs(lowOf(bounds)), abs(highOf(bounds)))); }

// Length of the shortest displacement in the box, px.
float shortestIn(vec4 bounds) { return lengthOf(clamp(vec2(0), lowOf(bounds), highOf(bounds))); }

// Box of the differences between each displacement in the box `bounds` and the displacement `of`.
vec4 relativeTo(vec4 bounds, vec2 of) { return bounds - vec4(of, of); }

// Greatest difference between a displacement in the box a and a displacement in the box b, px.
float farthestApart(vec4 a, vec4 b) { return lengthOf(max(abs(highOf(a) - lowOf(b)), abs(highOf(b) - lowOf(a)))); }

// Box of the offsets of surfaces from their places of the raster time, px, at all times of the exposure window `shutter` and
// for all displacements in the box `bounds`. The result contains 0.
vec4 travelled(vec4 bounds, vec2 shutter) {
  vec4 earliest = bounds * shutter.x, latest = bounds * shutter.y;
  vec2 low = min(min(lowOf(earliest), highOf(earliest)), min(lowOf(latest), highOf(latest)));
  vec2 high = max(max(lowOf(earliest), highOf(earliest)), max(lowOf(latest), highOf(latest)));
  return vec4(min(low, vec2(0)), max(high, vec2(0)));
}

#endif
