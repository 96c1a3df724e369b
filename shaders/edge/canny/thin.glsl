// SPDX-License-Identifier: MIT
// Thins a gradient to ridges one pixel wide; second of three steps of the Canny detector (Canny 1986).
// In:  `gradient`: along the steepest direction; length 1 at the threshold of strong edges
// Out: `ridge`:    1 where the length is above 1, 1/2 where it is above 1 / `ratio`, 0 elsewhere
// Method: non-maximum suppression. A pixel is 0 if one of its two neighbours across the edge, in the nearest of eight
//      directions, has a longer gradient. Of two equal neighbours the left or upper one stays.
// Fails: where three edges meet, one edge may end a pixel early.
#include "lib/blur.glsl"

const float kSector = 1.2071068;  // 1 / (2 tan 22.5 deg): rounds to an axis up to 22.5 degrees from it, otherwise to a diagonal

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
