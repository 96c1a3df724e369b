// SPDX-License-Identifier: MIT
// What a ray is expected to gain at a pixel, as one of few numbers that can be counted. Where two gains have one number
// neither comes first.
#ifndef STROBE_RANK_GLSL
#define STROBE_RANK_GLSL

// 0 where nothing is asked for, then 256 steps to each doubling of the gain from 2^-12; the last comes before all.
const uint kRanks = 4096u, kFirstRank = 4095u;
const float kStepsPerOctave = 256.0, kLeastOctave = -12.0;

uint rankOf(float gain) {
  float step = kStepsPerOctave * (log2(max(gain, 1e-30)) - kLeastOctave);
  return uint(clamp(step, 1.0, float(kFirstRank - 1u)));
}

#endif
