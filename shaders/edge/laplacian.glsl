// SPDX-License-Identifier: MIT
// Edges from second differences of inverse depth and normal (Laplace; LoG: Marr and Hildreth 1980).
// In:  `depth`:  view depth, m; +inf for the sky
//      `normal`: unit, world; 0 for the sky
//      `where`:  above 1/2 where to test; absent: everywhere
// Out: `edge`:   1 on an edge: two pixels wide at a step, four for the kernel `log`
// Method: sum the second differences over the four or eight neighbours. The kernel `log` is the Laplacian of a Gaussian of
//      standard deviation 1 px, (r^2 - 2) exp(-r^2 / 2), up to 3 px. Each kernel is scaled so that its response beside a unit
//      step along an axis is 1. 1/z is affine in screen space on a plane, so the response on planes is 0 at any angle. 1/z is
//      multiplied by the pixel's own depth, which makes it independent of scale. A pair of opposite neighbours with one outside
//      the image is ignored.
// Fails: a step gives edges on both of its sides. Noise gives more edges than with gradients. The depth step is a step of 1/z,
//      1 - near / far, and smaller than the step of z where the gap is large.
#include "mixin/edge.glsl"
#include "mixin/edge_features.glsl"
#include "mixin/edge_steps.glsl"

#if PARAM_kernel == kernel_log
const int kRadius = 3;
#else
const int kRadius = 1;
#endif

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
    float unit_step = 0.0;  // response to a step of 1 between this column and the next
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
