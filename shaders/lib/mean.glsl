// SPDX-License-Identifier: MIT
// Means that are kept while samples come in: rgb the mean so far, a the number of samples. A sum of thousands of equal
// numbers drifts by rounding; the mean of equal numbers is that number, bit for bit, however many there are.
#ifndef STROBE_MEAN_GLSL
#define STROBE_MEAN_GLSL

vec4 withSample(vec4 mean, vec3 value) {
  float count = mean.w + 1.0;
  return vec4(mean.rgb + (value - mean.rgb) / count, count);
}

// Of two such means, each weighted by its number of samples; black without any.
vec3 meanOfBoth(vec4 a, vec4 b) {
  float count = a.w + b.w;
  return count > 0.0 ? a.rgb + (b.rgb - a.rgb) * (b.w / count) : vec3(0);
}

#endif
