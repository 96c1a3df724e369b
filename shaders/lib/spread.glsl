// SPDX-License-Identifier: MIT
// How far colours are from each other.
#ifndef STROBE_SPREAD_GLSL
#define STROBE_SPREAD_GLSL

struct Spread {
  vec3 low, high;
};

Spread noSpread() { return Spread(vec3(3e38), vec3(-3e38)); }

Spread withColor(Spread spread, vec3 color) { return Spread(min(spread.low, color), max(spread.high, color)); }

// Do all lie within a share of the largest component of any? So does no colour at all.
bool isNarrow(Spread spread, float share) {
  vec3 apart = spread.high - spread.low, of = max(abs(spread.low), abs(spread.high));
  return max(apart.r, max(apart.g, apart.b)) <= share * max(of.r, max(of.g, of.b));
}

#endif
