// SPDX-License-Identifier: MIT
// Smallest and largest value of a set of colours, per channel.
#ifndef STROBE_SPREAD_GLSL
#define STROBE_SPREAD_GLSL

struct ColorRange {
  vec3 low, high;
};

ColorRange emptyColorRange() { return ColorRange(vec3(3e38), vec3(-3e38)); }

ColorRange withColor(ColorRange color_range, vec3 color) {
  return ColorRange(min(color_range.low, color), max(color_range.high, color));
}

// True if no channel differs by more than `share` times the largest magnitude of any channel; also true without colours.
bool isNarrow(ColorRange color_range, float share) {
  vec3 apart = color_range.high - color_range.low, of = max(abs(color_range.low), abs(color_range.high));
  return max(apart.r, max(apart.g, apart.b)) <= share * max(of.r, max(of.g, of.b));
}

#endif
