// SPDX-License-Identifier: MIT
// Range of a set of colours, per channel.
#ifndef STROBE_SPREAD_GLSL
#define STROBE_SPREAD_GLSL

struct Spread {
  vec3 low, high;
};

Spread noSpread() { return Spread(vec3(3e38), vec3(-3e38)); }

Spread withColor(Spread spread, vec3 color) { return Spread(min(spread.low, color), max(spread.high, color)); }

// True if the colours differ by at most the share `share` of their largest component; also true without colours.
bool isNarrow(Spread spread, float share) {
  vec3 apart = spread.high - spread.low, of = max(abs(spread.low), abs(spread.high));
  return max(apart.r, max(apart.g, apart.b)) <= share * max(of.r, max(of.g, of.b));
}

#endif
