// SPDX-License-Identifier: MIT
// How noisy one time per pixel leaves the picture (Oberberger, Chajdas, Westermann 2022, "Spatiotemporal Variance-Guided Filtering
// for Motion Blur"; here from the picture alone, without frames before it).
// In:  noisy (linear), moved (px over the exposure, of what is seen there at the pixel's time), dominant (the same, per tile).
// Out: variance of the tone (mixin/along_motion.glsl) over the pixels within 3 px along the dominant displacement; 0 where no pixel
//   within 8 px along it sees anything that moves: what they see is seen at all times, up to chance.
#include "mixin/along_motion.glsl"

const int kWide = 3;  // px
const int kLooks = 8;  // px: where one in a few sees what moves, others do as well

bool seesMotion(ivec2 at, ivec2 size) {
  return isInside(at, size) && lengthOf(vec2(texelFetch(moved_tex, at, 0))) > kStillRadius;
}

bool isReached(ivec2 pixel, vec2 d, ivec2 size) {
  for (int i = -kLooks; i <= kLooks; ++i)
    if (seesMotion(alongBy(pixel, d, float(i)), size)) return true;
  return false;
}

void run(ivec2 pixel) {
  vec2 d = dominantAt(pixel);
  ivec2 size = textureSize(noisy_tex, 0);
  float variance = 0.0;
  if (reachFactor(frame.shutter) * lengthOf(d) > kStillRadius && isReached(pixel, d, size)) {
    float own = tone(finiteColor(texelFetch(noisy_tex, pixel, 0))), sum = 0.0, squares = 0.0, count = 0.0;
    for (int i = -kWide; i <= kWide; ++i) {
      ivec2 at = alongBy(pixel, d, float(i));
      if (!isInside(at, size)) continue;
      float value = tone(finiteColor(texelFetch(noisy_tex, at, 0))) - own;  // small where alike: rounds less
      sum += value;
      squares += value * value;
      count += 1.0;
    }
    variance = max(squares / count - (sum / count) * (sum / count), 0.0);
  }
  imageStore(variance_img, pixel, vec4(variance));
}
