// SPDX-License-Identifier: MIT
// Variance, along the motion, of an image with one time sample per pixel (Oberberger, Chajdas, Westermann 2022, "Spatiotemporal
// Variance-Guided Filtering for Motion Blur"; here from one frame instead of several). The variance guides the filter
// filter/along_motion.glsl.
// In:  `noisy`: linear radiance, one time sample per pixel.
//      `moved`: displacement of the surface hit at the pixel's sample time, px over the exposure.
//      `dominant`: longest displacement that reaches each tile, px over the exposure.
// Out: `variance`: variance of the tone, which is luminance / (1 + luminance).
// Method: variance over the 7 pixels up to 3 px away along the dominant displacement. If no pixel up to 8 px away along this
//   line hits a moving surface, the variance is 0, because the pixels then most likely show one static surface at all times.
// Fails: a texture that varies along the motion counts as noise.
#include "mixin/along_motion.glsl"

// Largest distance from the filtered pixel to a pixel that the variance includes, px. With 2 or 6 instead, the error of
// the pipeline oberberger2022 changes by at most 3.4 % on five scenes.
const int kVarianceRadius = 3;
// Largest distance from the filtered pixel to a pixel that is tested for motion, px. A surface that passes over the
// filtered pixel is hit in some of the tested pixels, at their sample times. On five scenes of 160 x 90 and three of
// 320 x 180 pixels, 4 px instead of 8 px changes the error of oberberger2022 by -5 % to -13 %, and 16 px by
// +10 % to +25 %.
const int kMotionRadius = 8;

bool hitsMotion(ivec2 at, ivec2 size) {
  return isInside(at, size) && lengthOf(vec2(texelFetch(moved_tex, at, 0))) > kStaticRadius;
}

// True if the ray of the pixel, or of a pixel up to kMotionRadius px away along the displacement d, hits a moving
// surface.
bool isNearMotion(ivec2 pixel, vec2 d, ivec2 size) {
  for (int i = -kMotionRadius; i <= kMotionRadius; ++i)
    if (hitsMotion(alongBy(pixel, d, float(i)), size)) return true;
  return false;
}

void run(ivec2 pixel) {
  vec2 d = dominantAt(pixel);
  ivec2 size = textureSize(noisy_tex, 0);
  float variance = 0.0;
  if (spreadFactor(frame.shutter) * lengthOf(d) > kStaticRadius && isNearMotion(pixel, d, size)) {
    float own = tone(finiteColor(texelFetch(noisy_tex, pixel, 0))), sum = 0.0, squares = 0.0, count = 0.0;
    for (int i = -kVarianceRadius; i <= kVarianceRadius; ++i) {
      ivec2 at = alongBy(pixel, d, float(i));
      if (!isInside(at, size)) continue;
      float value = tone(finiteColor(texelFetch(noisy_tex, at, 0))) - own;  // differences reduce rounding errors
      sum += value;
      squares += value * value;
      count += 1.0;
    }
    variance = max(squares / count - (sum / count) * (sum / count), 0.0);
  }
  imageStore(variance_img, pixel, vec4(variance));
}
