// SPDX-License-Identifier: MIT
// Running means of colours: rgb is the mean so far, a is the number of samples. Running means replace sums, because a sum of
// thousands of equal numbers drifts by rounding. The running mean of equal numbers is that number, bit for bit, for any count.
#ifndef STROBE_MEAN_GLSL
#define STROBE_MEAN_GLSL

// Mean after one more sample.
vec4 withSample(vec4 mean, vec3 value) {
  float count = mean.w + 1.0;
  return vec4(mean.rgb + (value - mean.rgb) / count, count);
}

// Mean of two running means, weighted by their numbers of samples; black without samples.
vec3 meanOfBoth(vec4 a, vec4 b) {
  float count = a.w + b.w;
  return count > 0.0 ? a.rgb + (b.rgb - a.rgb) * (b.w / count) : vec3(0);
}

#endif
