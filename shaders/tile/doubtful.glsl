// SPDX-License-Identifier: MIT
// Per cell, at which times of the exposure anything may be there of which layers do not say truly where it is. Each cell
// says so of the cells that its own surfaces come to.
// In:  bounds, bends (of the displacements of what is doubtful in each cell at the capture, px over the exposure, and of how
//      far its paths are from straight lines in the middle of the exposure, px); behind_bounds, behind_bends (the same of
//      what was revealed); open_*, close_* (the same of what the ends of the exposure alone see).
//      What moves too little for filters to take notice of it is not doubted.
//      What crosses the picture between the ends of the exposure (frame.crossing) is doubted wherever it may be.
// Out: doubtful (a bit for each of `samples` times, at most 32).
#include "lib/bounds.glsl"
#include "mixin/limit.glsl"
#include "lib/times.glsl"

const float kSlack = 1.5;  // px: rounding, and the width of a tap

// All multiples of what is in a box by a number from `low` to `high`.
vec4 times(vec4 bounds, float low, float high) {
  vec4 a = bounds * low, b = bounds * high;
  return vec4(min(min(lowOf(a), highOf(a)), min(lowOf(b), highOf(b))), max(max(lowOf(a), highOf(a)), max(lowOf(b), highOf(b))));
}

// How far a path is from a straight line at a time, as a share of that in the middle of the window.
float bentShare(float t, vec2 window) { return 4.0 * (t - window.x) * (window.y - t); }

void doubt(ivec2 cell, vec4 way, uint bit) {
  vec2 low = vec2(cell * params.cell_side) + lowOf(way) - kSlack;
  vec2 high = vec2((cell + 1) * params.cell_side) + highOf(way) + kSlack;
  vec2 cells = vec2(pass_size());
  if (any(lessThan(high, vec2(0))) || any(greaterThan(low, cells * float(params.cell_side)))) return;
  ivec2 from = ivec2(max(low, vec2(0))) / params.cell_side;
  ivec2 to = ivec2(min(high / float(params.cell_side), cells - 1.0));
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) imageAtomicOr(doubtful_img, ivec2(x, y), bit);
  }
}

// From when to when a sample may be.
vec2 partTimes(int number, int count) {
  if (params.jittered == 0 && params.samples <= 32) return vec2(sampleTime(number, count, 0.0));
  return vec2(timeAt(float(number), count), timeAt(float(number + 1), count));
}

// As far as filters handle it.
bool isStill(vec4 bounds) { return reachFactor(frame.shutter) * min(longestIn(bounds), limitPx()) <= kStillRadius; }

// `seen`: the time, in exposures from the capture, at which the surfaces are where the cell says.
void doubtAll(ivec2 cell, vec4 bounds, vec4 bends, float seen) {
  if (isEmpty(bounds) || isStill(bounds)) return;
  int count = min(params.samples, 32);
  for (int i = 0; i < count; ++i) {
    float t = sampleTime(i, count, 0.0);
    vec2 during = partTimes(i, count);
    float low = during.x - seen, high = during.y - seen;
    float bent = bentShare(t, frame.shutter) - bentShare(seen, frame.shutter);
    vec4 way = times(bounds, low, high) + times(bends, min(bent, bent * 1.1), max(bent, bent * 1.1));
    doubt(cell, way, 1u << uint(i));
  }
}

// Whatever crosses the picture between the ends of the exposure: no layer holds it.
void doubtCrossing(ivec2 cell) {
  ivec4 pixels = ivec4(cell, cell + 1) * params.cell_side, area = frame.crossing;
  if (any(lessThanEqual(area.zw, pixels.xy)) || any(greaterThanEqual(area.xy, pixels.zw))) return;
  int count = min(params.samples, 32);
  for (int i = 0; i < count; ++i) {
    vec2 during = partTimes(i, count);
    if (during.y >= frame.crossing_times.x && during.x <= frame.crossing_times.y)
      imageAtomicOr(doubtful_img, cell, 1u << uint(i));
  }
}

void run(ivec2 cell) {
  doubtCrossing(cell);
  doubtAll(cell, texelFetch(bounds_tex, cell, 0), texelFetch(bends_tex, cell, 0), 0.0);
#if HAS_behind_bounds && HAS_behind_bends
  doubtAll(cell, texelFetch(behind_bounds_tex, cell, 0), texelFetch(behind_bends_tex, cell, 0), 0.0);
#endif
#if HAS_open_bounds && HAS_open_bends
  doubtAll(cell, texelFetch(open_bounds_tex, cell, 0), texelFetch(open_bends_tex, cell, 0), frame.shutter.x);
#endif
#if HAS_close_bounds && HAS_close_bends
  doubtAll(cell, texelFetch(close_bounds_tex, cell, 0), texelFetch(close_bends_tex, cell, 0), frame.shutter.y);
#endif
}
