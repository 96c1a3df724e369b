// SPDX-License-Identifier: MIT
// Edge detector `canny`, second of three steps: thins the gradient to ridges one pixel wide (Canny 1986).
// In:  `gradient`: vector along the steepest change; its length is the strength of the edge, 1 at the threshold of strong edges
//        (edge/canny/gradient.glsl).
// Out: `ridge`: 1 (strong) where the strength is above 1, 1/2 (weak) where it is above 1 / `ratio`, 0 elsewhere and beside
//        ridges.
// Method: non-maximum suppression. A pixel is on a ridge if neither of its two neighbours along the gradient, in the nearest of
//   eight directions, is stronger. Of two neighbouring pixels with equal strengths the left one stays, or the upper one if both
//   are in a column.
// Fails: where three edges meet, one edge may end a pixel early.
#include "lib/blur.glsl"

// Factor that rounds a gradient to one of eight directions: 1 / (2 tan 22.5 deg). The gradient is first scaled so that
// its larger component is 1 or -1. Then both components are multiplied by this factor and rounded to integers. The
// larger component becomes 1 or -1. The smaller component becomes 0 if the angle to the axis is below 22.5 degrees,
// because its value is then below 1/2; otherwise it becomes 1 or -1.
const float kSector = 1.2071068;

// Strength of the edge at a pixel: length of the gradient; 0 outside the image.
float strengthAt(ivec2 pixel) {
  if (!isInside(pixel, textureSize(gradient_tex, 0))) return 0.0;
  return length(vec2(texelFetch(gradient_tex, pixel, 0)));
}

void run(ivec2 pixel) {
  vec2 gradient = vec2(texelFetch(gradient_tex, pixel, 0));
  float strength = strengthAt(pixel);
  float ridge = 0.0;
  if (strength > 1.0 / params.ratio) {
    ivec2 across = roundSymmetric(kSector * gradient / max(abs(gradient.x), abs(gradient.y)));
    bool is_ridge = strength > strengthAt(pixel - across) && strength >= strengthAt(pixel + across);
    if (is_ridge) ridge = strength > 1.0 ? 1.0 : 0.5;
  }
  imageStore(ridge_img, pixel, vec4(ridge));
}
