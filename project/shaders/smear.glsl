// SPDX-License-Identifier: MIT
// Average of `taps` colours along the pixel's own displacement.
// In:  `color`: linear radiance. `velocity`: displacement, px over the exposure, y down.
// Out: `color`: linear radiance, alpha 1.
// Method: mean of the colours at X - t * displacement for pixel X; t: sample times, in exposures (0: raster time).
// Fails: moving surfaces are not blurred over static ones, and disoccluded background is missing.
#include "lib/times.glsl"

void run(ivec2 pixel) {
  vec2 displacement = vec2(texelFetch(velocity_tex, pixel, 0));
  ivec2 size = textureSize(color_tex, 0);
  vec3 mean = vec3(0);
  for (int i = 0; i < params.taps; ++i) {
    float t = sampleTime(i, params.taps, 0.0);  // depends on --anchor and --shutter-curve
    ivec2 tap = clampToImage(pixel + roundSymmetric(-t * displacement), size);
    mean += (vec3(texelFetch(color_tex, tap, 0)) - mean) / float(i + 1);  // equal colours stay exact
  }
  imageStore(color_img, pixel, vec4(mean, 1));
}
