// SPDX-License-Identifier: MIT
// Needs: dominant_tex, params.tile.
// The line along which pixels near each other see the same at different times.
#ifndef STROBE_ALONG_MOTION_GLSL
#define STROBE_ALONG_MOTION_GLSL
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

vec2 dominantAt(ivec2 pixel) { return vec2(texelFetch(dominant_tex, pixel / params.tile, 0)); }

// Pixels along d, `distance_px` from the one.
ivec2 alongBy(ivec2 pixel, vec2 d, float distance_px) { return pixel + roundSymmetric(d * (distance_px / lengthOf(d))); }

// In [0, 1), so that what is bright has differences that can be compared.
float tone(vec3 color) {
  float luminance = max(dot(color * kSumScale, vec3(0.2126, 0.7152, 0.0722)), 0.0) / kSumScale;
  return luminance < 1e6 ? luminance / (1.0 + luminance) : 1.0;
}

#endif
