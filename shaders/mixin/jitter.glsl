// SPDX-License-Identifier: MIT
// Needs: PARAM_jitter, PARAM_jitter_frame.
// Jitter of the sample times: a shift that differs from pixel to pixel. The parameters `jitter` and `jitter_frame` of a pass
// (passes/lib/jitter.lua) choose the noise. With `jitter_frame` = per_frame, the noise `hash` has new values in each frame, and
// the noise `ign` (interleaved gradient noise) is shifted in each frame by the golden ratio, which spreads the values of
// successive frames evenly.
#ifndef STROBE_JITTER_GLSL
#define STROBE_JITTER_GLSL
#include "lib/noise.glsl"

// Shift of the noise `ign` in the current frame, in [0, 1): fract(frame / golden ratio), computed in 32-bit fixed point.
float frameShift() { return float((frame.frame * 2654435769u) >> 8u) / 16777216.0; }

// Shift of the pixel's sample times, in [-1/2, 1/2) of the time between two samples; 0 with `jitter` = none.
float jitterOf(ivec2 pixel) {
#if PARAM_jitter == jitter_none
  return 0.0;
#elif PARAM_jitter == jitter_hash
#if PARAM_jitter_frame == jitter_frame_per_frame
  return hashNoise(pixel, frame.frame, frame.seed) - 0.5;
#else
  return hashNoise(pixel, 0u, frame.seed) - 0.5;
#endif
#else
  float value = gradientNoise(pixel);
#if PARAM_jitter_frame == jitter_frame_per_frame
  value = fract(value + frameShift());
#endif
  return value - 0.5;
#endif
}

#endif
