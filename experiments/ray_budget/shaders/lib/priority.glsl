// SPDX-License-Identifier: MIT
// Ray priority of a pixel: the expected gain of a ray (linear radiance), as an integer, so that a histogram can count the
// pixels of each priority.
#ifndef STROBE_RANK_GLSL
#define STROBE_RANK_GLSL

// Priority 0: the pixel gets no ray. Priorities 1 to 4094: gains from 2^-12 to 2^4, with 256 steps per doubling. Priority 4095,
// kFirstRank: the pixel comes before all others.
const uint kPriorities = 4096u, kFirstRank = 4095u;
const float kStepsPerOctave = 256.0, kLeastOctave = -12.0;

uint rankOf(float gain) {
  float step = kStepsPerOctave * (log2(max(gain, 1e-30)) - kLeastOctave);
  return uint(clamp(step, 1.0, float(kFirstRank - 1u)));
}

#endif
