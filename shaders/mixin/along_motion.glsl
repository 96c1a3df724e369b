// SPDX-License-Identifier: MIT
// Needs: dominant_tex, params.tile.
// Functions for filters that average pixels along the motion, in images with one time sample per pixel. In such an image,
// nearby pixels on a line along the dominant displacement show one surface at different times.
#ifndef STROBE_ALONG_MOTION_GLSL
#define STROBE_ALONG_MOTION_GLSL
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"

// Dominant displacement of the tile that contains the pixel, px over the exposure.
vec2 dominantAt(ivec2 pixel) { return vec2(texelFetch(dominant_tex, pixel / params.tile, 0)); }

// Pixel at the distance `distance_px` from `pixel` in the direction of d, rounded to whole pixels. The result may be outside of
// the image. d: displacement, px; not 0.
ivec2 alongBy(ivec2 pixel, vec2 d, float distance_px) { return pixel + roundSymmetric(d * (distance_px / lengthOf(d))); }

// Luminance L of a linear colour, compressed to L / (1 + L), in [0, 1]. Differences between bright colours are then comparable
// with differences between dark colours. From L = 1e6 on the result is 1.
float tone(vec3 color) {
  float luminance = max(dot(color * kSumScale, vec3(0.2126, 0.7152, 0.0722)), 0.0) / kSumScale;
  return luminance < 1e6 ? luminance / (1.0 + luminance) : 1.0;
}

#endif
