// SPDX-License-Identifier: MIT
// Replacement of NaN and infinity, which a degenerate matrix or an overflowing light may put into an image. Filters replace
// such a texel where they read it, so that it does not spread beyond its own pixel. Finite values pass unchanged.
#ifndef STROBE_SANITISE_GLSL
#define STROBE_SANITISE_GLSL

const float kLargestFinite = 3.402823466e38;
const float kInfinityStandIn = 65504.0;  // the largest half float

// The value if it is finite; 0 for NaN, +-65504 for +-infinity.
float finite(float value) {
  if (abs(value) <= kLargestFinite) return value;
  return value > 0.0 ? kInfinityStandIn : (value < 0.0 ? -kInfinityStandIn : 0.0);
}

// Scale of colours in sums: sums of thousands of the largest floats stay finite. A power of two causes no rounding.
const float kSumScale = 1.0 / 16384.0;

vec3 toSum(vec3 color) { return color * kSumScale; }

vec3 fromSum(vec3 sum) { return clamp(sum / kSumScale, -kLargestFinite, kLargestFinite); }

vec3 finiteColor(vec4 texel) { return vec3(finite(texel.x), finite(texel.y), finite(texel.z)); }

vec2 finiteDisplacement(vec4 texel) { return vec2(finite(texel.x), finite(texel.y)); }

// View depth without NaN: NaN counts as sky (+infinity, which is a valid depth), a negative depth as 0.
float saneDepth(float depth) { return depth >= 0.0 ? depth : (depth < 0.0 ? 0.0 : uintBitsToFloat(0x7f800000u)); }

#endif
