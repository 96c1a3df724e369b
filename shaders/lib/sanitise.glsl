// SPDX-License-Identifier: MIT
// Buffers may hold NaN or infinity (a degenerate matrix, an overflowing light). Filters replace such a texel where they
// read it, so that it never spreads beyond its own pixel. Finite values pass unchanged.
#ifndef STROBE_SANITISE_GLSL
#define STROBE_SANITISE_GLSL

const float kLargestFinite = 3.402823466e38;
const float kInfinityStandIn = 65504.0;  // the largest half float

// NaN to 0, +-infinity to +-65504.
float finite(float value) {
  if (abs(value) <= kLargestFinite) return value;
  return value > 0.0 ? kInfinityStandIn : (value < 0.0 ? -kInfinityStandIn : 0.0);
}

// Sums of colours are kept this much smaller, so that those of thousands of the largest numbers are finite. A power of
// two rounds nothing.
const float kSumScale = 1.0 / 16384.0;

vec3 toSum(vec3 color) { return color * kSumScale; }

vec3 fromSum(vec3 sum) { return clamp(sum / kSumScale, -kLargestFinite, kLargestFinite); }

vec3 finiteColor(vec4 texel) { return vec3(finite(texel.x), finite(texel.y), finite(texel.z)); }

vec2 finiteDisplacement(vec4 texel) { return vec2(finite(texel.x), finite(texel.y)); }

// View depth: NaN counts as sky (+infinity), which is a depth like any other; nothing is nearer than 0.
float saneDepth(float depth) { return depth >= 0.0 ? depth : (depth < 0.0 ? 0.0 : uintBitsToFloat(0x7f800000u)); }

#endif
