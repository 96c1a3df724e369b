// SPDX-License-Identifier: MIT
// Range of a set of colours: smallest and largest value of each channel. Used to test if the colours are nearly equal.
#ifndef STROBE_COLOR_RANGE_GLSL
#define STROBE_COLOR_RANGE_GLSL

struct ColorRange {
  vec3 low, high;
};

ColorRange emptyColorRange() { return ColorRange(vec3(3e38), vec3(-3e38)); }

ColorRange withColor(ColorRange color_range, vec3 color) {
  return ColorRange(min(color_range.low, color), max(color_range.high, color));
}

// True if the range is at most the share `share` of the colours: in no channel is high - low larger than `share` times the
// largest magnitude of any channel. Also true for an empty range.
bool isNarrow(ColorRange color_range, float share) {
  vec3 apart = color_range.high - color_range.low, of = max(abs(color_range.low), abs(color_range.high));
  return max(apart.r, max(apart.g, apart.b)) <= share * max(of.r, max(of.g, of.b));
}

#endif
