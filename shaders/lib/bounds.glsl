// SPDX-License-Identifier: MIT
// Boxes of displacements: least x and y, greatest x and y, px over the exposure. What a cell of pixels moves by lies in
// its box, so a filter may pass over a cell whose box shows that nothing in it concerns the pixel.
#ifndef STROBE_BOUNDS_GLSL
#define STROBE_BOUNDS_GLSL
#include "lib/blur.glsl"

// Of nothing: what is added to it is the box of that alone.
const vec4 kNoBounds = vec4(1e30, 1e30, -1e30, -1e30);

vec2 lowOf(vec4 bounds) { return vec2(bounds.x, bounds.y); }

vec2 highOf(vec4 bounds) { return vec2(bounds.z, bounds.w); }

bool isEmpty(vec4 bounds) { return bounds.x > bounds.z; }

// Length of the longest and of the shortest displacement that a box may hold.
float longestIn(vec4 bounds) { return lengthOf(max(abs(lowOf(bounds)), abs(highOf(bounds)))); }

float shortestIn(vec4 bounds) { return lengthOf(clamp(vec2(0), lowOf(bounds), highOf(bounds))); }

// All d - of with d in the box.
vec4 relativeTo(vec4 bounds, vec2 of) { return bounds - vec4(of, of); }

// The longest difference of a displacement in one box and one in the other.
float farthestApart(vec4 a, vec4 b) { return lengthOf(max(abs(highOf(a) - lowOf(b)), abs(highOf(b) - lowOf(a)))); }

// Where what moves by one of them is within the window, relative to where it is at the capture: low, high.
vec4 travelled(vec4 bounds, vec2 shutter) {
  vec4 earliest = bounds * shutter.x, latest = bounds * shutter.y;
  vec2 low = min(min(lowOf(earliest), highOf(earliest)), min(lowOf(latest), highOf(latest)));
  vec2 high = max(max(lowOf(earliest), highOf(earliest)), max(lowOf(latest), highOf(latest)));
  return vec4(min(low, vec2(0)), max(high, vec2(0)));
}

#endif
