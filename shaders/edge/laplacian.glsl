// SPDX-License-Identifier: MIT
// Edges from second differences of inverse depth and normal (Laplace; LoG: Marr and Hildreth 1980).
// In:  depth (view depth, sky +inf), normal (unit, world; sky 0), where (> 1/2: look here; absent: everywhere).
// Out: edge, 1 on an edge: two pixels wide at a step, four for the kernel log.
// Kernels: four and eight neighbours; log, the Laplacian of a Gaussian of standard deviation 1, (r^2 - 2) exp(-r^2 / 2)
//   to 3 px. Each is scaled so that a unit step along an axis responds 1 beside it. On a plane 1/z is affine in screen
//   space, so planes answer 0 at any angle. 1/z is multiplied by the pixel's own depth, so that no scale is built in.
//   Pairs of opposite neighbours of which one is outside of the picture do not count.
// Fails: a double response, on both sides of a step; noise, more than with gradients; a step is a step of 1/z, smaller
//   than that of z where the gap is large (1 - near / far).
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
    float unit_step = 0.0;  // the answer to a step of 1 between this column and the next
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
