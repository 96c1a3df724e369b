// SPDX-License-Identifier: MIT
// Per cell, the time strata that may contain a surface at a position that the layers do not describe.
// In:  `bounds`:   displacements of the unreliable surfaces of each cell at the raster time, px over the exposure
//      `deviation_bounds`:    their path deviations in the middle of the exposure, px
//      `background_bounds`, `background_deviation_bounds`: displacements and path deviations of the revealed layer
//      `shutter_open_bounds`, `shutter_open_deviation_bounds`: displacements and path deviations of surfaces visible only at
//        shutter open
//      `shutter_close_bounds`, `shutter_close_deviation_bounds`: displacements and path deviations of surfaces visible only at
//        shutter close
// Out: `unreliable`: bit i is set if stratum i of `samples` is unreliable; with more than 32 samples, stratum i of 32
// Method: for each stratum, move the cell's box by all multiples of `bounds` within the stratum plus `deviation_bounds` times
//      the change of the parabola 4 u (1 - u), widen it by kSlack, and set the bit in all cells that it overlaps (atomic or).
//      Displacements too small to blur are skipped. Cells in `frame.crossing` are marked at `frame.crossing_times`: there a
//      surface may be visible that is outside the image at the raster time and at both ends.
// Fails: a path that no parabola follows may leave its box. A cell with different motions marks too many cells around it.
#include "lib/bounds.glsl"
#include "mixin/limit.glsl"
#include "lib/times.glsl"

const float kSlack = 1.5;  // px: room for rounding and for the width of a tap

// Box of all multiples, by factors from `low` to `high`, of the displacements in a box.
vec4 times(vec4 bounds, float low, float high) {
  vec4 a = bounds * low, b = bounds * high;
  return vec4(min(min(lowOf(a), highOf(a)), min(lowOf(b), highOf(b))), max(max(lowOf(a), highOf(a)), max(lowOf(b), highOf(b))));
}

// Path deviation at time t as a share of the deviation in the middle of the exposure, for a parabola.
float deviationShare(float t, vec2 window) { return 4.0 * (t - window.x) * (window.y - t); }

// Marks the cells that a cell's box overlaps after moving by the displacements in `way`.
void unreliability(ivec2 cell, vec4 way, uint bit) {
  vec2 low = vec2(cell * params.cell_side) + lowOf(way) - kSlack;
  vec2 high = vec2((cell + 1) * params.cell_side) + highOf(way) + kSlack;
  vec2 cells = vec2(pass_size());
  if (any(lessThan(high, vec2(0))) || any(greaterThan(low, cells * float(params.cell_side)))) return;
  ivec2 from = ivec2(max(low, vec2(0))) / params.cell_side;
  ivec2 to = ivec2(min(high / float(params.cell_side), cells - 1.0));
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) imageAtomicOr(unreliable_img, ivec2(x, y), bit);
  }
}

// Earliest and latest time of a sample. Without jitter a stratum of a single sample is one time.
vec2 partTimes(int number, int count) {
  if (params.jittered == 0 && params.samples <= 32) return vec2(sampleTime(number, count, 0.0));
  return vec2(timeAt(float(number), count), timeAt(float(number + 1), count));
}

// True if all displacements, shortened to the limit, are too small to blur.
bool isStatic(vec4 bounds) { return spreadFactor(frame.shutter) * min(longestIn(bounds), limitPx()) <= kStaticRadius; }

// `visible_part`: time when the surfaces lie in the cell, in exposures from the raster time. Deviations get a margin of 10 %,
// because paths are only nearly parabolas; the value is not derived.
void markAllUnreliable(ivec2 cell, vec4 bounds, vec4 deviation_bounds, float visible_part) {
  if (isEmpty(bounds) || isStatic(bounds)) return;
  int count = min(params.samples, 32);
  for (int i = 0; i < count; ++i) {
    float t = sampleTime(i, count, 0.0);
    vec2 during = partTimes(i, count);
    float low = during.x - visible_part, high = during.y - visible_part;
    float nonlinear = deviationShare(t, frame.shutter) - deviationShare(visible_part, frame.shutter);
    vec4 way = times(bounds, low, high) +
               times(deviation_bounds, min(nonlinear, nonlinear * 1.1), max(nonlinear, nonlinear * 1.1));
    unreliability(cell, way, 1u << uint(i));
  }
}

// Surfaces that cross the image between the ends of the exposure are in no layer.
void markUnreliable(ivec2 cell) {
  ivec4 pixels = ivec4(cell, cell + 1) * params.cell_side, area = frame.crossing;
  if (any(lessThanEqual(area.zw, pixels.xy)) || any(greaterThanEqual(area.xy, pixels.zw))) return;
  int count = min(params.samples, 32);
  for (int i = 0; i < count; ++i) {
    vec2 during = partTimes(i, count);
    if (during.y >= frame.crossing_times.x && during.x <= frame.crossing_times.y)
      imageAtomicOr(unreliable_img, cell, 1u << uint(i));
  }
}

void run(ivec2 cell) {
  markUnreliable(cell);
  markAllUnreliable(cell, bounds_at(cell), deviation_bounds_at(cell), 0.0);
  markAllUnreliable(cell, background_bounds_at(cell), background_deviation_bounds_at(cell), 0.0);
  markAllUnreliable(cell, shutter_open_bounds_at(cell), shutter_open_deviation_bounds_at(cell), frame.shutter.x);
  markAllUnreliable(cell, shutter_close_bounds_at(cell), shutter_close_deviation_bounds_at(cell), frame.shutter.y);
}
