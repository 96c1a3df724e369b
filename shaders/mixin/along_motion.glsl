// SPDX-License-Identifier: MIT
// Needs: dominant_tex, params.tile.
// Pixels on the line of the dominant displacement. Nearby pixels of such a line show the same surface at different times.
#ifndef STROBE_ALONG_MOTION_GLSL
#define STROBE_ALONG_MOTION_GLSL
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

// Dominant displacement of the pixel's tile, px over the exposure.
vec2 dominantAt(ivec2 pixel) { return vec2(texelFetch(dominant_tex, pixel / params.tile, 0)); }

// Pixel at the distance `distance_px` from `pixel`, in the direction of d.
ivec2 alongBy(ivec2 pixel, vec2 d, float distance_px) { return pixel + roundSymmetric(d * (distance_px / lengthOf(d))); }

// Luminance mapped to [0, 1], so that differences between bright colours are comparable with differences between dark ones.
float tone(vec3 color) {
  float luminance = max(dot(color * kSumScale, vec3(0.2126, 0.7152, 0.0722)), 0.0) / kSumScale;
  return luminance < 1e6 ? luminance / (1.0 + luminance) : 1.0;
}

#endif
