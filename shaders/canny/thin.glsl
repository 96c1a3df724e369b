// SPDX-License-Identifier: MIT
// Ridges of a gradient, one pixel wide; second step of the edge detector canny (Canny 1986).
// In:  gradient (its length is the answer, 1 at the threshold of strong edges; along the steepest direction).
// Out: ridge: 1 where the answer is above 1, 1/2 where it is above 1 / ratio, 0 elsewhere and where one of the
//   neighbours across the edge (the nearest of eight directions) answers more. Of equal ones the right or lower one
//   goes.
// Fails: where three edges meet one may be cut off a pixel before the others.
#include "lib/blur.glsl"

const float kSector = 1.2071068;  // 1 / (2 tan 22.5 deg): diagonals begin halfway between axes and diagonals

float answerAt(ivec2 pixel) {
  if (!isInside(pixel, textureSize(gradient_tex, 0))) return 0.0;
  return length(vec2(texelFetch(gradient_tex, pixel, 0)));
}

void run(ivec2 pixel) {
  vec2 gradient = vec2(texelFetch(gradient_tex, pixel, 0));
  float answer = answerAt(pixel);
  float ridge = 0.0;
  if (answer > 1.0 / params.ratio) {
    ivec2 across = roundSymmetric(kSector * gradient / max(abs(gradient.x), abs(gradient.y)));
    bool is_ridge = answer > answerAt(pixel - across) && answer >= answerAt(pixel + across);
    if (is_ridge) ridge = answer > 1.0 ? 1.0 : 0.5;
  }
  imageStore(ridge_img, pixel, vec4(ridge));
}
