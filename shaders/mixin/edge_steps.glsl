// SPDX-License-Identifier: MIT
// Needs: params.depth_threshold, params.normal_threshold, PARAM_combine.
// Strength of an edge from a step of depth and a step of the normal. Each step is divided by its threshold: `depth_threshold`
// is a share of the pixel's depth, `normal_threshold` is the length of the difference of two unit normals.
#ifndef STROBE_EDGE_STEPS_GLSL
#define STROBE_EDGE_STEPS_GLSL

// Strength of an edge; a pixel with a strength above 1 is an edge. The parameter `combine` chooses the larger of the two
// relative steps (`max`), their sum (`sum`), or the smaller one (`and`). `depth_step`: share of the pixel's depth.
// `normal_step`: length.
float combined(float depth_step, float normal_step) {
  float in_depth = depth_step / params.depth_threshold;
  float in_normal = normal_step / params.normal_threshold;
#if PARAM_combine == combine_sum
  return in_depth + in_normal;
#elif PARAM_combine == combine_and
  return min(in_depth, in_normal);
#else
  return max(in_depth, in_normal);
#endif
}

#endif
