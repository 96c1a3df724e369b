// SPDX-License-Identifier: MIT
// Needs: nothing; may have: PARAM_color_format, PARAM_depth_encoding, PARAM_velocity_format, count_color_clamped,
//   count_depth_lost, count_velocity_clamped, scene.
// Quantisation of colours, displacements and depths to the memory formats of a renderer. Passes with the parameters
// velocity_format, color_format or depth_encoding of passes/lib/quantised.lua, and with their counters, include this file.
// In:  linear colours; displacements, px over the exposure; linear view depths, metres (+inf for the sky, 0 for no surface).
// Out: the quantised values. The formats fp32 and linear return the input bit for bit, without arithmetic.
// Method, half floats: round to nearest, ties to even. The shader rounds, because a device may truncate when it stores the
//   value. A colour channel beyond 65504 becomes 65504. A displacement beyond 65504 px is scaled until its larger component is
//   65504, so that it keeps its direction. Counters count both cases. The largest rounding error is relative 2^-11 for
//   magnitudes from 2^-14 on, and absolute 2^-25 below.
// Method, depths: encode as a depth buffer does, then decode. With the near distance n of the camera at the raster time and the
//   view depth z:
//   reversed  w = n/z in fp32 (infinite reversed z; sky 0); relative error about 2^-24 for each of two divisions;
//   inverse   w = 1/z in fp32 (sky 0); the error of `reversed`, independent of the near distance;
//   unorm24   1 - n/z in 24 bits (infinite standard z; sky 1); relative error up to z/(n * 2^25).
//   The formulas are also used for an orthographic camera, although its own projection is linear.
//   NaN, infinity and a depth of 0 are unchanged in every format. Readers replace NaN and infinity (lib/sanitise.glsl).
// Fails: the encoding unorm24 turns surfaces farther than 2^25 n into sky. The encodings reversed and inverse do so where w
//   rounds to 0, from a depth of about 1e38 n and 1e38 m on. The counter depth_lost counts these surfaces. The encodings assume
//   that all surfaces are at the near distance n or farther.
#ifndef STROBE_QUANTISED_GLSL
#define STROBE_QUANTISED_GLSL

const float kLargestHalf = 65504.0;

// Nearest half float of a value with a magnitude of at most 65504, as a float. Infinity and NaN are unchanged.
float nearestHalf(float value) {
  uint sign_bit = floatBitsToUint(value) & 0x80000000u, magnitude = floatBitsToUint(value) & 0x7fffffffu;
  if (magnitude >= 0x7f800000u) return value;
  if (magnitude < 0x38800000u)  // half floats below 2^-14 are multiples of 2^-24
    magnitude = floatBitsToUint(roundEven(uintBitsToFloat(magnitude) * 16777216.0) / 16777216.0);
  else  // from 2^-14 on, the mantissa of a half float is 13 bits shorter
    magnitude = (magnitude + 0xfffu + ((magnitude >> 13) & 1u)) & 0xffffe000u;
  return uintBitsToFloat(sign_bit | magnitude);
}

// True if the value is finite and beyond the range of half floats.
bool overflowsHalf(float value) { return abs(value) > kLargestHalf && !isinf(value); }

// Colour in the format `color_format`. Counts `color_clamped` if a channel is clamped. Unchanged if the pass lacks this
// parameter.
vec4 quantisedColor(vec4 color) {
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

// Displacement, px over the exposure, in the format `velocity_format`. Counts `velocity_clamped` if the displacement is
// shortened. Unchanged if the pass lacks this parameter.
vec2 quantisedVelocity(vec2 velocity) {
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
// View depth, metres, after encoding to `depth_encoding` and decoding. +inf, counted as `depth_lost`, if the code of the depth
// is the code of the sky.
float quantisedDepth(float depth) {
#if PARAM_depth_encoding == depth_encoding_linear
  return depth;
#else
  if (!(depth > 0.0) || isinf(depth)) return depth;
  float near = scene_cameras[SLICE_RASTER].near, quantised, decoded;
#if PARAM_depth_encoding == depth_encoding_reversed
  quantised = min(near / depth, 1.0);
  decoded = near / quantised;
#elif PARAM_depth_encoding == depth_encoding_inverse
  quantised = min(1.0 / depth, 3.402823466e38);
  decoded = 1.0 / quantised;
#else
  // The shader quantises n/z instead of the code 1 - n/z, in steps of 1 / (2^24 - 1). n/z is the distance of the code
  // from 1, and single precision represents the number of its steps exactly.
  quantised = round(min(near / depth, 1.0) * 16777215.0);
  decoded = near * 16777215.0 / quantised;
#endif
  if (quantised > 0.0) return decoded;
  count_depth_lost(1u);
  return uintBitsToFloat(0x7f800000u);
#endif
}
#endif

#endif
