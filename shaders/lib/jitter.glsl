// SPDX-License-Identifier: MIT
// The jitter of a pass with the choice parameter `jitter` = none | ign | hash: in [-1/2, 1/2] of the distance between
// two samples, one value per pixel.
#ifndef STROBE_JITTER_GLSL
#define STROBE_JITTER_GLSL
#include "lib/noise.glsl"

float jitterOf(ivec2 pixel) {
#if PARAM_jitter == jitter_ign
  return gradientNoise(pixel) - 0.5;
#elif PARAM_jitter == jitter_hash
  return hashNoise(pixel, frame.frame, frame.seed) - 0.5;
#else
  return 0.0;
#endif
}

#endif
