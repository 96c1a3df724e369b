// SPDX-License-Identifier: MIT
// Edge detector: marks pixels where the second difference of inverse depth or of the normal is large (Laplacian; kernel `log`,
// the Laplacian of a Gaussian: Marr and Hildreth 1980).
// In:  `depth`: view depth, metres; +inf for the sky.
//      `normal`: unit normal in world space; 0 for the sky.
//      `where`: mask, above 1/2 at the pixels to test (absent: all pixels are tested).
// Out: `edge`: 1 on an edge, otherwise 0. An edge at a step is two pixels wide, or four with the kernel `log`.
// Method: the values of a neighbour are its normal and the pixel's depth divided by the neighbour's depth z. 1/z is affine in
//   screen space on a plane, so planes have the response 0 at any angle. The quotient does not depend on the scale of the
//   scene.
//   A second difference is the sum of the values at two opposite neighbours minus twice the value at the pixel. Add the second
//   differences over the neighbours of the kernel: four, eight, or for `log` all up to 3 px away along x and y, with the weight
//   (r^2 - 2) exp(-r^2 / 2) at the distance r px. Skip a pair if one of its two neighbours is outside the image. Scale the sum
//   so that a step along an axis has the response 1 beside the step.
//   Divide the responses of depth and normal by their thresholds. The pixel is an edge if both together exceed 1 (parameter
//   `combine`).
// Fails: marks both sides of a step. Noise gives more edges than with gradients. At the nearer pixel a depth step counts as
//   1 - near / far, less than with gradients (far / near - 1), so that large gaps stand out less.
#include "mixin/edge.glsl"
#include "mixin/edge_features.glsl"
#include "mixin/edge_steps.glsl"

#if PARAM_kernel == kernel_log
const int kRadius = 3;
#else
const int kRadius = 1;
#endif

// Weight of the neighbour at `offset` in the kernel.
float weightAt(ivec2 offset) {
#if PARAM_kernel == kernel_four
  return abs(offset.x) + abs(offset.y) == 1 ? 1.0 : 0.0;
#elif PARAM_kernel == kernel_eight
  return 1.0;
#else
  float squared_px = float(offset.x * offset.x + offset.y * offset.y);
  return (squared_px - 2.0) * exp(-0.5 * squared_px);
#endif
}

void run(ivec2 pixel) {
  float depth = depthAt(pixel);
  bool edge = false;
  if (isWanted(pixel) && isSurface(depth)) {
    vec4 sum = vec4(0);
    float unit_step = 0.0;  // unscaled response to a step of 1 between the pixel's column and the next
    for (int y = -kRadius; y <= kRadius; ++y) {
      for (int x = 0; x <= kRadius; ++x) {
        float weight = weightAt(ivec2(x, y));
        if (x > 0) unit_step += weight;
        if (x > 0 || y > 0) sum += weight * secondDifference(pixel, ivec2(x, y), depth);
      }
    }
    sum /= unit_step;
    edge = combined(abs(sum.w), length(vec3(sum))) > 1.0;
  }
  markEdge(pixel, edge);
}
