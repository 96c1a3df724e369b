// SPDX-License-Identifier: MIT
// The average of `taps` colours along the pixel's own displacement, at times that share the exposure.
// In:  color (linear), velocity (px over the exposure, y down).
// Out: color (linear, alpha 1).
// Method: at time t, in exposures from the raster time, pixel X shows the surface at X - displacement * t.
// Fails: a surface at rest stays sharp beside and behind a moving one.
#include "lib/times.glsl"

void run(ivec2 pixel) {
  vec2 displacement = vec2(texelFetch(velocity_tex, pixel, 0));
  ivec2 size = textureSize(color_tex, 0);
  vec3 mean = vec3(0);
  for (int i = 0; i < params.taps; ++i) {
    float t = sampleTime(i, params.taps, 0.0);  // by --anchor and --shutter-curve
    ivec2 tap = clampToImage(pixel + roundSymmetric(-t * displacement), size);
    mean += (vec3(texelFetch(color_tex, tap, 0)) - mean) / float(i + 1);  // exact where all are equal
  }
  imageStore(color_img, pixel, vec4(mean, 1));
}
