// SPDX-License-Identifier: MIT
// Marks, per cell, the time strata in which the layers are unreliable: a surface may be in the cell at a place that the layers
// do not describe.
// In:  `bounds`, `deviation_bounds`: per cell, bounds of the displacements (px over the exposure) and of the path deviations in
//        the middle of the exposure (px) of the raster layer's unreliable texels (marked by `nonlinear` of path_deviation or
//        path_curve)
//      `background_bounds`, `background_deviation_bounds`: these bounds for the revealed layer
//      `shutter_open_bounds`, `shutter_open_deviation_bounds`: these bounds for surfaces that are visible only at shutter open
//      `shutter_close_bounds`, `shutter_close_deviation_bounds`: these bounds for surfaces that are visible only at shutter
//        close
// Out: `unreliable`: bit i is set if stratum i of `samples` is unreliable; with more than 32 samples, stratum i of 32
// Method: for each stratum, move the box of the cell's pixels along all paths within the bounds. A path is a displacement times
//   the elapsed time, plus a path deviation times the change of the parabola 4 u (1 - u), where u is the share of the exposure
//   that has passed. Widen the result by kSlack px, and set the bit in all cells that the result overlaps (atomic or). Skip
//   displacements too small to blur. Also mark the cells in `frame.crossing` at `frame.crossing_times`: a surface that is
//   outside the image at the raster time and at both ends of the exposure may cross these cells.
// Fails: a surface on a path that is not a parabola may leave the marked cells. A cell with different motions marks too many
//   cells around.
#include "lib/bounds.glsl"
#include "mixin/limit.glsl"
#include "lib/times.glsl"

const float kSlack = 1.5;  // margin of each box, px; covers rounding and the width of a tap

// Box of all displacements in `bounds` multiplied by all factors from `low` to `high`.
vec4 times(vec4 bounds, float low, float high) {
  vec4 a = bounds * low, b = bounds * high;
  return vec4(min(min(lowOf(a), highOf(a)), min(lowOf(b), highOf(b))), max(max(lowOf(a), highOf(a)), max(lowOf(b), highOf(b))));
}

// Path deviation at time t (in exposures from the raster time) as a share of the deviation in the middle of the exposure, for a
// parabola. `window`: times of shutter open and shutter close.
float deviationShare(float t, vec2 window) { return 4.0 * (t - window.x) * (window.y - t); }

// Sets `bit` in all cells that the box of the cell overlaps after it moves by the displacements in `way`, px.
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

// Earliest and latest time of stratum `number` of `count`, in exposures from the raster time. Without jitter, a stratum with a
// single sample is one time.
vec2 partTimes(int number, int count) {
  if (params.jittered == 0 && params.samples <= 32) return vec2(sampleTime(number, count, 0.0));
  return vec2(timeAt(float(number), count), timeAt(float(number + 1), count));
}

// True if all displacements in the bounds, shortened to the parameter `limit`, are too small to blur.
bool isStatic(vec4 bounds) { return spreadFactor(frame.shutter) * min(longestIn(bounds), limitPx()) <= kStaticRadius; }

// For each stratum, marks the cells that unreliable surfaces of a cell may reach. `visible_part`: time when the surfaces are in
// the cell, in exposures from the raster time. Deviations have a margin of 10 %, because paths are only nearly parabolas; this
// value is not derived.
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

// Marks the cell at the strata within `frame.crossing_times` if it overlaps the rectangle `frame.crossing`. Surfaces that cross
// the image between the ends of the exposure are in no layer.
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
