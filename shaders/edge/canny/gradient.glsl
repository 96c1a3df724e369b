// SPDX-License-Identifier: MIT
// Gradient of depth and normal of the smoothed image; first of three steps of the Canny detector (Canny 1986).
// In:  `depth`:    view depth, m; +inf for the sky
//      `normal`:   unit, world; 0 for the sky
// Out: `gradient`: along the steepest direction, px, x right, y down; length 1 at the threshold. Of the two directions along
//                   that line, the direction with x > 0, or with x = 0 and y > 0
// Method: convolve with a Gaussian of standard deviation 1 px (5 x 5) and with Sobel's kernel, as one kernel of 7 x 7, scaled
//      so that the response beside a unit step is 1. Depths are relative to the pixel's own, as in edge/sobel: at a step the
//      nearer pixel has the larger response and remains. The direction is the principal axis of the summed outer products of
//      the gradients of depth and of each component of the normal, each divided by its threshold (Di Zenzo 1986).
// Fails: edges closer together than about 3 px merge, and corners become round.
#include "mixin/edge_features.glsl"
#include "mixin/edge_steps.glsl"

// exp(-r^2 / 2) at r = 0, 1, 2, normalised to a sum of 1 over the five taps.
const float kGauss[5] = float[](0.40261996, 0.24420134, 0.05448868, 0.0, 0.0);

// Convolution of the Gaussian with [1 2 1] / 4 and with [-1 0 1], at -3 to 3.
float smoothAt(int i) { return 0.25 * (kGauss[abs(i - 1)] + kGauss[abs(i + 1)]) + 0.5 * kGauss[abs(i)]; }
float slopeAt(int i) { return (kGauss[abs(i - 1)] - kGauss[abs(i + 1)]) / (kGauss[0] + kGauss[1]); }

vec2 principalAxis(float xx, float xy, float yy) {
  float angle = 0.5 * atan(2.0 * xy, xx - yy);
  return vec2(cos(angle), sin(angle));
}

void run(ivec2 pixel) {
  float depth = depthAt(pixel);
  vec2 gradient = vec2(0);
  if (isSurface(depth)) {
    vec4 in_x = vec4(0), in_y = vec4(0);
    for (int y = -3; y <= 3; ++y) {
      for (int x = -3; x <= 3; ++x) {
        vec4 feature = featureAt(pixel + ivec2(x, y), depth);
        in_x += slopeAt(x) * smoothAt(y) * feature;
        in_y += smoothAt(x) * slopeAt(y) * feature;
      }
    }
    vec4 scale = 1.0 / vec4(vec3(params.normal_threshold), params.depth_threshold);
    vec4 a = scale * in_x, b = scale * in_y;
    vec2 axis = principalAxis(dot(a, a), dot(a, b), dot(b, b));
    float normal_step = sqrt(dot(vec3(in_x), vec3(in_x)) + dot(vec3(in_y), vec3(in_y)));
    gradient = axis * combined(length(vec2(in_x.w, in_y.w)), normal_step);
  }
  imageStore(gradient_img, pixel, vec4(gradient, 0, 0));
}
