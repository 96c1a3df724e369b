// SPDX-License-Identifier: MIT
// One level of an a-trous wavelet filter along the motion, which removes the noise of an image with one time sample per pixel
// (Oberberger, Chajdas, Westermann 2022, "Spatiotemporal Variance-Guided Filtering for Motion Blur", after SVGF, Schied et al.
// 2017).
// In:  `noisy`: linear radiance, from the previous level.
//      `variance`: variance V of the tone, which is luminance / (1 + luminance), from the previous level.
//      `dominant`: longest displacement that reaches each tile, px over the exposure.
// Out: `blurred`: linear radiance, alpha 1.
//      `less`: variance of the tone in `blurred`.
// Method: `octave` is the number of the level, from 0. For k = -2 to 2, C(k) is the colour k * 2^octave px away along
//   the dominant displacement.
//     blurred = sum h(k) w(k) C(k) / sum h(k) w(k)
//     less = sum h(k)^2 w(k)^2 V(k) / (sum h(k) w(k))^2
//     w(k) = exp(-|tone(k) - tone(0)| / (deviations * sigma + kSlack))
//   h is the B-spline 1/16, 1/4, 3/8, 1/4, 1/16. w keeps differences above the noise. sigma is the standard deviation,
//   from V averaged over 3 pixels along the line, and `deviations` a parameter.
//   Pixels with the variance 0 are copied. Pixels are also copied if the distance 2^octave px is more than half of the
//   dominant displacement, and more than 1 px, because pixels so far away show other surfaces.
// Fails: surfaces with different motions are all blurred along the longest displacement. Textures and silhouettes along it are
//   blurred if their contrast is within the noise. Noise in patches longer than the widest level remains.
#include "mixin/along_motion.glsl"

// Weights of the B-spline at the distances 0, 1 and 2.
const float kSpline[3] = float[3](3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0);

// Difference of tones, luminance / (1 + luminance), that reduces the weight to 1/e where the image has no noise. This
// constant prevents a division by 0. Halving or doubling the constant changes the error of the pipeline oberberger2022
// by at most 0.8 % on five scenes.
const float kSlack = 1e-3;

float varianceAt(ivec2 at) { return max(finite(texelFetch(variance_tex, at, 0).x), 0.0); }

// Standard deviation of the tone at a pixel, from the variance at 3 pixels along d.
float deviationAt(ivec2 pixel, vec2 d, ivec2 size) {
  float sum = 0.0, weights = 0.0;
  for (int i = -1; i <= 1; ++i) {
    ivec2 at = alongBy(pixel, d, float(i));
    if (!isInside(at, size)) continue;
    float weight = i == 0 ? 0.5 : 0.25;
    sum += weight * varianceAt(at);
    weights += weight;
  }
  return sqrt(sum / weights);
}

void run(ivec2 pixel) {
  vec4 own = texelFetch(noisy_tex, pixel, 0);
  float variance = varianceAt(pixel), apart = exp2(float(params.octave));
  vec2 d = dominantAt(pixel);
  if (variance == 0.0 || apart > max(0.5 * lengthOf(d), 1.0)) {
    imageStore(blurred_img, pixel, own);
    imageStore(less_img, pixel, vec4(variance));
    return;
  }

  ivec2 size = textureSize(noisy_tex, 0);
  float here = tone(finiteColor(own)), within = params.deviations * deviationAt(pixel, d, size) + kSlack;
  vec3 sum = vec3(0);
  float weights = 0.0, left = 0.0;
  for (int k = -2; k <= 2; ++k) {
    ivec2 at = alongBy(pixel, d, float(k) * apart);
    if (!isInside(at, size)) continue;
    vec3 color = finiteColor(texelFetch(noisy_tex, at, 0));
    float weight = kSpline[abs(k)] * exp(-abs(tone(color) - here) / within);
    sum += weight * toSum(color);
    weights += weight;
    left += weight * weight * varianceAt(at);
  }
  imageStore(blurred_img, pixel, vec4(fromSum(sum / weights), 1));
  imageStore(less_img, pixel, vec4(left / (weights * weights)));
}
