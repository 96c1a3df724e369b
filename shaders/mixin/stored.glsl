// SPDX-License-Identifier: MIT
// Needs: nothing; may have: PARAM_color_format, PARAM_depth_encoding, PARAM_velocity_format, count_color_clamped,
//   count_depth_lost, count_velocity_clamped, scene.
// What a renderer's memory would keep of colours, displacements and depths. For passes with the parameters
// velocity_format, color_format or depth_encoding of passes/lib/stored.lua and the counters to them.
// In:  linear colours; displacements, px over the exposure; linear view depths, m (sky +inf, 0 where there is nothing).
// Out: the same as they come back from memory. With fp32 and linear: bit for bit what was given, without arithmetic.
// Half floats: to the nearest, ties to even, here and not by the store, which may truncate. Beyond 65504 a colour's
//   channel becomes 65504, and a displacement is shortened until its larger component is 65504, so that it keeps its
//   direction; both are counted. Relative error at most 2^-11 from 2^-14 up, absolute error at most 2^-25 below.
// Depths: through the number that a depth buffer would hold and back. With n the camera's near distance:
//   reversed  w = n/z in fp32 (infinite reversed z; sky 0); relative error about 2^-24 for each of two divisions;
//   inverse   w = 1/z in fp32 (sky 0); the same, without the near distance;
//   unorm24   1 - n/z in 24 bits (infinite standard z; sky 1): relative error up to z/(n * 2^25).
//   An orthographic camera, whose own projection is linear, has its near distance in the same formulas.
// NaN and infinity are kept: readers replace them (lib/sanitise.glsl), whatever the format. A depth of 0 is kept too.
// Fails: unorm24 takes what is farther than 2^25 near distances for sky, and reversed and inverse what is so far that w
//   is 0 (about 1e38 times farther than n or 1 m); counted as depth_lost. Nothing is nearer than the near distance.
#ifndef STROBE_STORED_GLSL
#define STROBE_STORED_GLSL

const float kLargestHalf = 65504.0;

// To the nearest half float; of at most 65504 in magnitude, or infinite, or NaN.
float nearestHalf(float value) {
  uint sign_bit = floatBitsToUint(value) & 0x80000000u, magnitude = floatBitsToUint(value) & 0x7fffffffu;
  if (magnitude >= 0x7f800000u) return value;
  if (magnitude < 0x38800000u)  // below 2^-14 half floats are the multiples of 2^-24
    magnitude = floatBitsToUint(roundEven(uintBitsToFloat(magnitude) * 16777216.0) / 16777216.0);
  else  // above, 13 bits shorter
    magnitude = (magnitude + 0xfffu + ((magnitude >> 13) & 1u)) & 0xffffe000u;
  return uintBitsToFloat(sign_bit | magnitude);
}

// Finite and beyond half floats?
bool overflowsHalf(float value) { return abs(value) > kLargestHalf && !isinf(value); }

vec4 storedColor(vec4 color) {
#if defined(PARAM_color_format) && PARAM_color_format == color_format_fp16
  bool clamped = false;
  for (int i = 0; i < 4; ++i) {
    if (overflowsHalf(color[i])) {
      color[i] = color[i] > 0.0 ? kLargestHalf : -kLargestHalf;
      clamped = true;
    }
    color[i] = nearestHalf(color[i]);
  }
  if (clamped) count_color_clamped(1u);
#endif
  return color;
}

vec2 storedVelocity(vec2 velocity) {
#if defined(PARAM_velocity_format) && PARAM_velocity_format == velocity_format_fp16
  float largest = max(abs(velocity.x), abs(velocity.y));
  if (overflowsHalf(largest)) {
    velocity = velocity / largest * kLargestHalf;
    count_velocity_clamped(1u);
  }
  velocity = vec2(nearestHalf(velocity.x), nearestHalf(velocity.y));
#endif
  return velocity;
}

#if defined(PARAM_depth_encoding)
float storedDepth(float depth) {
#if PARAM_depth_encoding == depth_encoding_linear
  return depth;
#else
  if (!(depth > 0.0) || isinf(depth)) return depth;
  float near = scene_cameras[SLICE_CAPTURE].near, stored, decoded;
#if PARAM_depth_encoding == depth_encoding_reversed
  stored = min(near / depth, 1.0);
  decoded = near / stored;
#elif PARAM_depth_encoding == depth_encoding_inverse
  stored = min(1.0 / depth, 3.402823466e38);
  decoded = 1.0 / stored;
#else
  // Of the code 1 - n/z of 2^24 - 1 steps the distance from 1, which single precision can hold.
  stored = round(min(near / depth, 1.0) * 16777215.0);
  decoded = near * 16777215.0 / stored;
#endif
  if (stored > 0.0) return decoded;
  count_depth_lost(1u);
  return uintBitsToFloat(0x7f800000u);
#endif
}
#endif

#endif
