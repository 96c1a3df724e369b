// SPDX-License-Identifier: MIT
// Replacement of NaN and infinity in texels. A degenerate matrix or an overflowing light may produce such values. Filters
// replace them when they read a texel, so that one bad texel does not spread to other pixels. Finite values pass unchanged.
#ifndef STROBE_SANITISE_GLSL
#define STROBE_SANITISE_GLSL

const float kLargestFinite = 3.402823466e38;
const float kInfinityStandIn = 65504.0;  // largest finite half float

// The value if it is finite; 0 for NaN, +-65504 for +-infinity.
float finite(float value) {
  if (abs(value) <= kLargestFinite) return value;
  return value > 0.0 ? kInfinityStandIn : (value < 0.0 ? -kInfinityStandIn : 0.0);
}

// Scale of colours in sums. With this scale, sums of thousands of the largest floats stay finite. A power of two causes no
// rounding.
const float kSumScale = 1.0 / 16384.0;

// Colour in the scale of sums: scaled down by kSumScale, so that a sum of many colours stays finite.
vec3 toSum(vec3 color) { return color * kSumScale; }

// Inverse of `toSum`. The result is clamped to finite values.
vec3 fromSum(vec3 sum) { return clamp(sum / kSumScale, -kLargestFinite, kLargestFinite); }

vec3 finiteColor(vec4 texel) { return vec3(finite(texel.x), finite(texel.y), finite(texel.z)); }

vec2 finiteDisplacement(vec4 texel) { return vec2(finite(texel.x), finite(texel.y)); }

// View depth without NaN and negative values: NaN becomes +infinity, the depth of the sky; a negative depth becomes 0. A depth
// of +infinity is valid and passes unchanged.
float saneDepth(float depth) { return depth >= 0.0 ? depth : (depth < 0.0 ? 0.0 : uintBitsToFloat(0x7f800000u)); }

#endif
