// SPDX-License-Identifier: MIT
// Edge detector `canny`, first of three steps: gradient of the smoothed depth and normal (Canny 1986).
// In:  `depth`: view depth, metres; +inf for the sky.
//      `normal`: unit normal in world space; 0 for the sky.
// Out: `gradient`: vector along the steepest change, x right, y down; its length is the strength of the edge, 1 at the
//        threshold. The direction has no sign: of the two opposite vectors, the one with x > 0 is stored, or with x = 0 and
//        y > 0.
// Method: smooth with a Gaussian of standard deviation 1 px (5x5 taps) and convolve with Sobel's kernel, both in one kernel of
//   7x7 taps, scaled so that a step of 1 has the response 1 beside the step. Depths are divided by the depth of the pixel: at a
//   depth step the nearer pixel then has the larger response, and the next step of the detector keeps this pixel.
//   Length: the gradients of depth and normal, each divided by its threshold, combined by the parameter `combine`. Direction:
//   principal axis of the sum of outer products of the gradients of depth and of each component of the normal, each divided by
//   its threshold (Di Zenzo 1986).
// Fails: edges closer together than about 3 px merge, and corners become round.
#include "mixin/edge_features.glsl"
#include "mixin/edge_steps.glsl"

// Gaussian exp(-r^2 / 2) at the distances r = 0 to 4 px: cut off beyond 2 px, and scaled to a sum of 1 over the taps -2 to 2.
const float kGauss[5] = float[](0.40261996, 0.24420134, 0.05448868, 0.0, 0.0);

// Weights of the kernel at the offset i, -3 to 3 px. smoothAt, across the gradient: the Gaussian convolved with [1 2 1] / 4.
// slopeAt, along the gradient: the Gaussian convolved with [-1 0 1], scaled so that a step of 1 has the response 1.
float smoothAt(int i) { return 0.25 * (kGauss[abs(i - 1)] + kGauss[abs(i + 1)]) + 0.5 * kGauss[abs(i)]; }
float slopeAt(int i) { return (kGauss[abs(i - 1)] - kGauss[abs(i + 1)]) / (kGauss[0] + kGauss[1]); }

// Unit vector along the eigenvector with the larger eigenvalue of the symmetric matrix (xx xy; xy yy).
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
