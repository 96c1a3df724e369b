// SPDX-License-Identifier: MIT
// Variance of an image with one time sample per pixel, along the motion (Oberberger, Chajdas, Westermann 2022, "Spatiotemporal
// Variance-Guided Filtering for Motion Blur"; here from one frame, without earlier frames).
// In:  noisy: linear radiance, one time sample per pixel.
//      moved: displacement of the surface at the pixel's time, px over the exposure.
//      dominant: longest displacement that reaches each tile, px over the exposure.
// Out: variance: variance of the tone (mixin/along_motion.glsl).
// Method: variance over the pixels within 3 px along the dominant displacement. The variance is 0 if no pixel within 8 px along
//   the displacement shows a moving surface. These pixels then most likely show the same surface at all times.
// Fails: a texture along the motion counts as noise.
#include "mixin/along_motion.glsl"

const int kWide = 3;  // px
const int kLooks = 8;  // px; a surface that moves across shows at some of these pixels at their sample times

bool seesMotion(ivec2 at, ivec2 size) {
  return isInside(at, size) && lengthOf(vec2(texelFetch(moved_tex, at, 0))) > kStaticRadius;
}

bool isInMovingRect(ivec2 pixel, vec2 d, ivec2 size) {
  for (int i = -kLooks; i <= kLooks; ++i)
    if (seesMotion(alongBy(pixel, d, float(i)), size)) return true;
  return false;
}

void run(ivec2 pixel) {
  vec2 d = dominantAt(pixel);
  ivec2 size = textureSize(noisy_tex, 0);
  float variance = 0.0;
  if (spreadFactor(frame.shutter) * lengthOf(d) > kStaticRadius && isInMovingRect(pixel, d, size)) {
    float own = tone(finiteColor(texelFetch(noisy_tex, pixel, 0))), sum = 0.0, squares = 0.0, count = 0.0;
    for (int i = -kWide; i <= kWide; ++i) {
      ivec2 at = alongBy(pixel, d, float(i));
      if (!isInside(at, size)) continue;
      float value = tone(finiteColor(texelFetch(noisy_tex, at, 0))) - own;  // differences, to reduce rounding
      sum += value;
      squares += value * value;
      count += 1.0;
    }
    variance = max(squares / count - (sum / count) * (sum / count), 0.0);
  }
  imageStore(variance_img, pixel, vec4(variance));
}
